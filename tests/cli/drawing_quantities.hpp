#pragma once
/// Quantities of the drawings of a command, for tests that are written as text.

#include <nlohmann/json.hpp>

#include "plotting/paths/optimize.hpp"
#include "plotting/readers/drawing_reader.hpp"
#include "support/standard.hpp"

namespace ligne::test {

using nlohmann::json;

struct Extent {
  double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300;
};

/// Extent of all strokes, or of those of a class.
inline Extent extent_of(const json& drawing, const std::string& line_class) {
  Extent box;
  for (const json& stroke : drawing["strokes"]) {
    if (!line_class.empty() && stroke["class"] != line_class) continue;
    for (const json& point : stroke["points"]) {
      const double x = point[0], y = point[1];
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    }
  }
  return box;
}

/// Length of the strokes of a class, or of all, on the page that are seen, or hidden.
inline double length_mm(const json& drawing, const std::string& line_class, bool visible) {
  double sum = 0;
  for (const json& s : drawing["strokes"]) {
    if ((line_class != "all" && s["class"] != line_class) || s["visible"].get<bool>() != visible) continue;
    const auto a = s["points"][0].get<std::array<double, 2>>(), b = s["points"][1].get<std::array<double, 2>>();
    sum += std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  return sum;
}

/// The lines of a drawing in any order, each with its class, its source and the part of it, to a ten-thousandth.
inline std::string pieces_of(const json& drawing) {
  std::multiset<std::string> pieces;
  for (const json& s : drawing["strokes"]) {
    std::string text = s["class"].get<std::string>() + ' ' + s["source"].dump();
    for (const json& end : s["interval"]) text += ' ' + std::to_string(std::lround(1e4 * end.get<double>()));
    pieces.insert(text);
  }
  std::string all;
  for (const std::string& piece : pieces) all += piece + '\n';
  return all;
}

/// The parts of the JSON at the pointer, in which * stands for each part of a list or of an object.
inline std::vector<json> parts_at(const json& whole, const std::string& pointer) {
  const std::size_t star = pointer.find("/*");
  if (star == pointer.npos) return {pointer == "/" ? whole : whole.at(json::json_pointer(pointer))};
  std::vector<json> all;
  for (const json& part : whole.at(json::json_pointer(pointer.substr(0, star))))
    for (json& found : parts_at(part, pointer.substr(star + 2))) all.push_back(std::move(found));
  return all;
}

/// Length of the lines of an SVG, or of those of a layer, mm.
inline double drawn_length(const std::string& svg, const std::string& layer) {
  const ReadDrawing read = read_svg_drawing(svg, "script", {});
  double length = 0;
  for (const Layer& l : read.drawing.layers)
    if (layer.empty() || l.name == layer) length += measure(l.lines, {0, 0}, false).down_mm;
  return length;
}

}  // namespace ligne::test
