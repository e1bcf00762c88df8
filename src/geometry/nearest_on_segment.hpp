#pragma once
/// The point of a segment that is nearest to a given point, on the page and in space.

#include <algorithm>
#include <glm/geometric.hpp>

namespace ligne {

/// Parameter of the nearest point: 0 at `from`, 1 at `to`, 0 if the segment has no length. Rounded.
template <class Point>
double nearest_on_segment(const Point& p, const Point& from, const Point& to) {
  const Point along = to - from;
  const double square = glm::dot(along, along);
  return square > 0 ? std::clamp(glm::dot(p - from, along) / square, 0.0, 1.0) : 0;
}

/// Square of the distance of a point from a segment. Rounded.
template <class Point>
double squared_distance(const Point& p, const Point& from, const Point& to) {
  const Point away = p - (from + (to - from) * nearest_on_segment(p, from, to));
  return glm::dot(away, away);
}

}  // namespace ligne
