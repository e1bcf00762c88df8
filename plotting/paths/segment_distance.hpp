#pragma once
/// The distance of a point from a segment.

#include <algorithm>

#include <glm/geometric.hpp>

#include "geometry/point.hpp"

namespace ligne {

/// The square of the distance of `p` from the segment `a`-`b`, whose ends may be the same point.
inline double squared_distance(Point2 p, Point2 a, Point2 b) {
  const Point2 along = b - a;
  const double length = glm::dot(along, along);
  const double t = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
  const Point2 away = p - (a + along * t);
  return glm::dot(away, away);
}

}  // namespace ligne
