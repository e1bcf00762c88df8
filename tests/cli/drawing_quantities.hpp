#pragma once
/// Quantities of the drawings of a command, for tests that are written as text, and runs of `ligne surface`.

#include "main/tier.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/readers/drawing_reader.hpp"
#include "program.hpp"

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

class SurfaceProgramTest : public ProgramTest {
 protected:
  Outcome surface(const Words& arguments, const Words& more) const { return run("surface" + arguments + more); }
  nlohmann::json drawn(const Words& arguments) const {
    const Outcome outcome = surface(arguments, "-o - --format json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.status == 0 ? nlohmann::json::parse(outcome.out) : nlohmann::json();
  }
  /// Length of the lines of each layer in mm.
  std::map<std::string, double> layers(const Words& arguments) const {
    const Outcome outcome = surface(arguments, "-o - --format svg");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return layers_of(outcome.out);
  }
  /// Lengths of the layers of an SVG.
  static std::map<std::string, double> layers_of(const std::string& svg) {
    std::map<std::string, double> lengths;
    std::string layer;
    std::istringstream lines(svg);
    for (std::string line; std::getline(lines, line);) {
      if (const auto id = line.find(" id=\""); line.starts_with("<g ")) {
        layer = line.substr(id + 5, line.find('"', id + 5) - id - 5);
      } else if (line.starts_with("<path d=\"M")) {
        lengths[layer] += path_length(line.substr(10, line.find('"', 10) - 10));
      }
    }
    return lengths;
  }
  void fails(const Words& arguments, int status, const std::string& message) const {
    const Outcome outcome = surface(arguments, {});
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("ligne: " + message, 0), 0u) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }

 private:
  /// "x y l dx dy dx dy ..." or "x y L x y x y ...", with or without Z at the end.
  static double path_length(std::string d) {
    const bool closed = d.back() == 'Z', relative = d.find('l') != std::string::npos;
    for (char& c : d)
      if (c == 'l' || c == 'L' || c == 'Z') c = ' ';
    std::istringstream numbers(d);
    double x = 0, y = 0, last_x = 0, last_y = 0, length = 0;
    numbers >> last_x >> last_y;
    const double first_x = last_x, first_y = last_y;
    while (numbers >> x >> y) {
      if (relative) x += last_x, y += last_y;
      length += std::hypot(x - last_x, y - last_y);
      last_x = x;
      last_y = y;
    }
    EXPECT_TRUE(numbers.eof()) << d;
    return closed ? length + std::hypot(first_x - last_x, first_y - last_y) : length;
  }
};

/// Page length of the visible strokes of a class, in model units of a parallel view.
inline double length(const nlohmann::json& drawing, const std::string& line_class) {
  const auto& m = drawing["view"]["matrix"];
  return length_mm(drawing, line_class, true) / std::hypot(m[0].get<double>(), m[1].get<double>(), m[2].get<double>());
}

}  // namespace ligne::test
