#pragma once
/// Points and vectors. GLM's double vectors are used as they are, everywhere.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ligne {

using Point2 = glm::dvec2;
using Point3 = glm::dvec3;

/// Area of the parallelogram of u and v: positive when the turn from u to v is the turn from +x towards +y.
inline double cross(Point2 u, Point2 v) { return u.x * v.y - u.y * v.x; }

/// Axis-aligned rectangle [min.x, max.x] x [min.y, max.y]. Empty (min > max) until extended.
struct Rect {
  Point2 min{+1e300, +1e300};
  Point2 max{-1e300, -1e300};

  bool empty() const { return min.x > max.x || min.y > max.y; }
  double width() const { return max.x - min.x; }
  double height() const { return max.y - min.y; }
  void extend(Point2 p) {
    if (p.x < min.x) min.x = p.x;
    if (p.y < min.y) min.y = p.y;
    if (p.x > max.x) max.x = p.x;
    if (p.y > max.y) max.y = p.y;
  }
};

}  // namespace ligne
