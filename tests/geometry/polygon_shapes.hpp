#pragma once
/// Polygons of any size that are hard to triangulate quickly.

#include "geometry/point.hpp"
#include "support/standard.hpp"

namespace ligne::shapes {

using Contour = std::vector<Point2>;
/// The outer contour and holes.
using Polygon = std::vector<Contour>;

struct Shape {
  const char* name;
  bool simple;           ///< no contours cross, and none lies where the outer one does not wind
  std::string contours;  ///< as text, of a number n of corners, of n/2, n/3, n/4, and of the root of n/4
  Polygon make(int corners) const;
};

struct Flat {
  std::vector<Point2> points;
  std::vector<std::uint32_t> contour_end;
};

inline Flat flatten(const Polygon& polygon) {
  Flat flat;
  for (const Contour& contour : polygon) {
    flat.points.insert(flat.points.end(), contour.begin(), contour.end());
    flat.contour_end.push_back(static_cast<std::uint32_t>(flat.points.size()));
  }
  return flat;
}

inline Contour rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

const std::vector<Shape>& all_shapes();

}  // namespace ligne::shapes
