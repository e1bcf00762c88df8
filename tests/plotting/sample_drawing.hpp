#pragma once
/// Drawings, lines and texts that several tests of plotting share.

#include "drawing/measures.hpp"
#include "geometry/elliptic_arc.hpp"
#include "main/script.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/writers/number_text.hpp"
#include "plotting/writers/writers.hpp"
#include "support/line_text.hpp"
#include "support/test.hpp"

namespace ligne {

inline void add_line(Drawing& drawing, std::string_view layer, const std::vector<Point2>& points) {
  if (drawing.layers.empty() || drawing.layers.back().name != layer) drawing.layers.push_back({std::string(layer), {}});
  Polylines& lines = drawing.layers.back().lines;
  lines.points.insert(lines.points.end(), points.begin(), points.end());
  lines.begin.push_back(static_cast<std::uint32_t>(lines.points.size()));
}

/// A small drawing with everything in it.
inline Drawing sample_drawing() {
  Drawing drawing;
  add_line(drawing, "hidden", {{20, 20}, {100, 150}, {190, 20}});
  add_line(drawing, "mesh", {{30, 200}, {60.5, 210.25}, {90, 200.0001}});
  add_line(drawing, "mesh", {{0.12345, -3}, {0, -2.5}});
  add_line(drawing, "outline", {{20, 20}, {190, 20}, {190, 277}, {20, 277}, {20, 20}});
  add_line(drawing, "outline", {{100, 150}, {100, 250}});
  return drawing;
}

inline StrokeModel sample_strokes() {
  StrokeModel model;
  model.lattice.origin_mm = {100, 100};
  model.lattice.step_mm = 0.125;
  model.edge_count = 2;
  Stroke s;
  s.from = {0, 0};
  s.to = {80, 1};
  s.line_class = LineClass::outline;
  s.t_to = 0.25;
  model.strokes.push_back(s);
  s.from = {-8, -8};
  s.source = 2;
  s.line_class = LineClass::intersection;
  s.visible = false;
  model.strokes.push_back(s);
  model.intersections.push_back({{Point3{0, 0, 0}, Point3{1, 2, 3}}, {4, 5}, true});
  return model;
}

inline SourceEdge sample_source(const StrokeModel& model, std::uint32_t source) {
  if (source >= model.edge_count) return model.intersections[source - model.edge_count];
  return {{Point3{0.1, 0, 0}, Point3{1e-7, 2.5, -3}}, {7, 0xffffffffu}, false};
}

inline Polylines polylines_of(const std::vector<std::vector<Point2>>& lists) {
  Polylines lines;
  for (const auto& list : lists) {
    lines.points.insert(lines.points.end(), list.begin(), list.end());
    lines.begin.push_back(static_cast<std::uint32_t>(lines.points.size()));
  }
  return lines;
}

/// The value rounded to so many decimals.
inline std::string as_decimal(double value, int decimals = 6) {
  std::string text;
  append_rounded(text, value, decimals);
  return text;
}

inline std::string text_of_lines(const Polylines& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) text += ";";
    for (const Point2 p : lines[i]) text += (text.empty() ? "" : " ") + as_decimal(p.x) + "," + as_decimal(p.y);
  }
  return text;
}

/// The data of the paths of an SVG.
inline std::vector<std::string> path_data(const std::string& svg) {
  std::vector<std::string> data;
  for (const std::string& part : test::parts_of(svg, '<'))
    if (const std::size_t at = part.find(" d=\""); part.starts_with("path") && at != part.npos)
      data.push_back(part.substr(at + 4, part.find('"', at + 4) - at - 4));
  return data;
}

inline double total_length(const Polylines& lines) { return measure(lines, {0, 0}, false).down_mm; }

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180;

/// Corners of an ellipse from one eccentric angle to another.
inline std::vector<Point2> tessellated(const Ellipse& ellipse, double from, double sweep, int steps) {
  std::vector<Point2> points;
  for (int i = 0; i <= steps; ++i) points.push_back(point_at(ellipse, from + sweep * i / steps));
  return points;
}

inline std::vector<Point2> closed(const Ellipse& ellipse, int steps) {
  std::vector<Point2> points = tessellated(ellipse, 0.1, 2 * kPi, steps);
  points.back() = points.front();
  return points;
}

// Texts held against files of tests/golden/. Run with LIGNE_UPDATE_GOLDENS=1 to write them anew.

inline std::string golden_file(const std::string& name) { return LIGNE_SOURCE_DIR "/tests/golden/" + name; }

/// An empty text, or what is different.
inline std::string difference(const std::string& name, const std::string& text) {
  if (!std::filesystem::exists(golden_file(name))) return name + " is missing";
  const std::string wanted = test::bytes_of_file(golden_file(name));
  if (wanted == text) return "";
  const auto at =
      static_cast<std::size_t>(std::mismatch(wanted.begin(), wanted.end(), text.begin(), text.end()).first - wanted.begin());
  return name + " differs at byte " + std::to_string(at) + ": " + text.substr(at, 60);
}

inline void expect_golden(const std::string& name, const std::string& text) {
  if (std::getenv("LIGNE_UPDATE_GOLDENS")) std::ofstream(golden_file(name), std::ios::binary) << text;
  EXPECT_EQ(difference(name, text), "");
}

}  // namespace ligne
