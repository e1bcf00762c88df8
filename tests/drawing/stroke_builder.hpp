#pragma once
/// Short ways to strokes for tests. The lattice has a step of one millimetre, so that lattice points are page points.

#include "drawing/drawing.hpp"

namespace ligne {

inline Stroke stroke(LatticePoint from, LatticePoint to, LineClass line_class = LineClass::mesh, std::uint32_t source = 0) {
  Stroke s;
  s.from = from;
  s.to = to;
  s.line_class = line_class;
  s.source = source;
  return s;
}

inline Stroke hidden(Stroke s) {
  s.visible = false;
  return s;
}

inline Stroke at_depth(Stroke s, float z_from, float z_to) {
  s.z_from = z_from;
  s.z_to = z_to;
  return s;
}

inline StrokeModel model(std::vector<Stroke> strokes) {
  StrokeModel m;
  m.strokes = std::move(strokes);
  return m;
}

}  // namespace ligne
