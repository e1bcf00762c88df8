#pragma once
/// A small drawing with everything in it.

#include "plotting/writers.hpp"

namespace ligne {

inline void add_line(Drawing& drawing, std::string_view layer, const std::vector<Point2>& points) {
  if (drawing.layers.empty() || drawing.layers.back().name != layer) drawing.layers.push_back({std::string(layer), {}});
  Polylines& lines = drawing.layers.back().lines;
  lines.points.insert(lines.points.end(), points.begin(), points.end());
  lines.begin.push_back(static_cast<std::uint32_t>(lines.points.size()));
}

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

}  // namespace ligne
