#pragma once
/// Polygons of any size that are hard to triangulate quickly.

#include <vector>

#include "geometry/point.hpp"

namespace ligne::shapes {

using Contour = std::vector<Point2>;
/// The outer contour and holes.
using Polygon = std::vector<Contour>;

struct Shape {
  const char* name;
  bool simple;                   ///< no contours cross, and none lies where the outer one does not wind
  Polygon (*make)(int corners);  ///< with about so many corners
};

inline Contour rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

const std::vector<Shape>& all_shapes();

}  // namespace ligne::shapes
