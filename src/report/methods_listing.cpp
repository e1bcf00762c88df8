#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "report/listing.hpp"
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

}  // namespace ligne
