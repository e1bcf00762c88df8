#include "report/listing.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "files/message_text.hpp"
#include "plotting/devices/device.hpp"
#include "visibility/method_parts.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// The words for a method's treatment of transparent faces.
std::string_view transparency_words(TransparencyMode mode) {
  constexpr std::string_view kWords[] = {"drawn as opaque", "not drawn", "hides nothing", "drawn as transparent"};
  return kWords[static_cast<std::size_t>(mode)];
}

/// The options, or the settings for experiments, one a line.
std::string parameters_text(const MethodTraits& traits, std::string head, bool experiments) {
  std::string text;
  for (const MethodParameter& p : traits.parameters) {
    if (p.is_experiment != experiments) continue;
    text +=
        head + (experiments ? "--set " + std::string(p.name) + "=" : "--" + std::string(p.name) + " ") + std::string(p.kind);
    if (!p.standard.empty()) text += " [" + std::string(p.standard) + "]";
    text += ": " + std::string(p.meaning) + "\n";
    head.assign(head.size(), ' ');
  }
  return text;
}

std::string language_name(const Device& device) {
  return std::string(kDeviceLanguageNames[static_cast<std::size_t>(device.language)]);
}

std::string size_text(Point2 mm) {
  const auto side = [](double v) { return std::isfinite(v) ? rounded(v, 5) : std::string("any"); };
  return side(mm.x) + " x " + side(mm.y) + " mm";
}

std::string text_of(const Device& device) {
  std::string text = device.name + ": " + device.title + "\n";
  text += "  language     " + language_name(device) + ", step " + shortest(device.step_mm) + " mm, " +
          (device.pens == 0 ? "pens changed by hand" : std::to_string(device.pens) + (device.pens == 1 ? " pen" : " pens")) +
          "\n";
  if (device.papers.empty()) {
    text += "  reach        " + size_text({device.limits_mm.width(), device.limits_mm.height()}) + "\n";
  }
  const char* head = "  papers       ";
  for (const DevicePaper& paper : device.papers) {
    const Point2 reach{paper.limits.width() * device.step_mm, paper.limits.height() * device.step_mm};
    text += head + paper.name + ", reach " + size_text(reach) + (paper.note.empty() ? "" : ": " + paper.note) + "\n";
    head = "               ";
  }
  text += "  speed        " + shortest(device.down_mm_s) + " mm/s down, " + shortest(device.up_mm_s) + " mm/s up\n";
  if (!device.note.empty()) text += "  note         " + device.note + "\n";
  return text;
}

nlohmann::ordered_json json_of(const Rect& r) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const double v : {r.min.x, r.min.y, r.max.x, r.max.y})
    list.push_back(std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr));
  return list;
}

nlohmann::ordered_json json_of(const Device& device) {
  nlohmann::ordered_json json;
  json["name"] = device.name;
  json["title"] = device.title;
  json["language"] = language_name(device);
  json["step_mm"] = device.step_mm;
  json["pens"] = device.pens;
  if (device.papers.empty()) {
    json["limits_mm"] = json_of(device.limits_mm);
  } else {
    json["papers"] = nlohmann::ordered_json::array();
    for (const DevicePaper& paper : device.papers) {
      json["papers"].push_back({{"name", paper.name},
                                {"width_mm", paper.width_mm},
                                {"height_mm", paper.height_mm},
                                {"limits", json_of(paper.limits)}});
    }
  }
  json["speed_down_mm_s"] = device.down_mm_s;
  json["speed_up_mm_s"] = device.up_mm_s;
  json["lift_s"] = device.lift_s;
  json["note"] = device.note;
  return json;
}

}  // namespace

std::vector<std::string> product_names(std::uint8_t products) {
  constexpr std::pair<Product, const char*> names[] = {
      {kStrokes, "strokes"}, {kRegions, "regions"}, {kOrder, "order"}, {kSpans, "spans"}, {kPixels, "pixels"}};
  std::vector<std::string> list;
  for (const auto& [product, name] : names) {
    if (products & product) list.emplace_back(name);
  }
  return list;
}

std::string precision_name(const MethodTraits& traits) { return traits.exact ? "exact" : "resolution-limited"; }

std::string methods_text(std::span<const Method* const> methods, bool settings) {
  const Method* default_method = find_method("auto");
  std::string text;
  for (const Method* method : methods) {
    const MethodTraits& traits = method->traits();
    text +=
        std::string(traits.name) + (method == default_method ? " (auto)" : "") + ": " + std::string(traits.summary) + "\n";
    text += "  produces      " + joined(product_names(traits.products)) + "\n";
    text += "  precision     " + precision_name(traits) + "\n";
    text += std::string("  penetration   ") + (traits.penetration ? "drawn" : "not drawn") + "\n";
    text += "  transparency  " + std::string(transparency_words(traits.transparency)) + "\n";
    if (!traits.only_for.empty()) text += "  only for      " + std::string(traits.only_for) + "\n";
    text += "  paper         " + std::string(traits.paper) + "\n";
    text += parameters_text(traits, "  options       ", false);
    if (settings) text += parameters_text(traits, "  settings      ", true);
  }
  return text;
}

std::string methods_json(std::span<const Method* const> methods) {
  const Method* default_method = find_method("auto");
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Method* method : methods) {
    const MethodTraits& traits = method->traits();
    nlohmann::ordered_json entry;
    entry["name"] = traits.name;
    entry["summary"] = traits.summary;
    entry["produces"] = product_names(traits.products);
    entry["exact"] = traits.exact;
    entry["penetration"] = traits.penetration;
    entry["transparency"] = transparency_words(traits.transparency);
    if (!traits.only_for.empty()) entry["only_for"] = traits.only_for;
    entry["paper"] = traits.paper;
    entry["default"] = method == default_method;
    entry["parts"] = nlohmann::ordered_json::array();
    if (const SevenParts* parts = seven_parts_of(traits.name)) {
      for (std::size_t i = 0; i < kMethodParts.size(); ++i) {
        entry["parts"].push_back(
            {{"symbol", kMethodParts[i].symbol}, {"meaning", kMethodParts[i].meaning}, {"text", (*parts)[i]}});
      }
    }
    entry["options"] = nlohmann::ordered_json::array();
    for (const MethodParameter& p : traits.parameters) {
      entry["options"].push_back({{"name", p.name},
                                  {"value", p.kind},
                                  {"default", p.standard},
                                  {"meaning", p.meaning},
                                  {"experiment", p.is_experiment}});
    }
    list.push_back(std::move(entry));
  }
  return nlohmann::ordered_json{{"format", "ligne-methods"}, {"version", 1}, {"methods", std::move(list)}}.dump(2) + "\n";
}

std::string devices_text() {
  std::string text;
  for (const Device& device : devices()) text += text_of(device);
  return text;
}

std::string devices_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Device& device : devices()) list.push_back(json_of(device));
  const nlohmann::ordered_json json{{"format", "ligne-devices"}, {"version", 1}, {"devices", std::move(list)}};
  return json.dump(2) + "\n";
}

}  // namespace ligne
