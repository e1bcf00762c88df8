#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "files/message_text.hpp"
#include "plotting/devices/device.hpp"
#include "report/listing.hpp"

namespace ligne {
namespace {

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
