#pragma once
/// Finds the visible side of a triangle.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "visibility/horizon/level.hpp"
#include "visibility/horizon/plane_projection.hpp"

namespace ligne::horizon {

/// 1 if the corners turn counter-clockwise for the viewer, -1 if clockwise, 0 if the triangle is seen edge on: it is
/// then no thicker on the drawing plane than the difference of level heights, since rounding must not separate its
/// sides. `picture` is the picture's width in parallel projection; in perspective it is 0, and the distance of the
/// corners takes its place. The points may lie behind the eye.
inline std::int8_t facing_of(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r, double picture) {
  if (picture > 0) {  // w is 1, which simplifies the determinant
    const double turn = (q.x * r.y - q.y * r.x) + (r.x * p.y - r.y * p.x) + (p.x * q.y - p.y * q.x);
    const double extent =
        std::max(std::max(std::abs(q.x - p.x), std::abs(q.y - p.y)), std::max(std::abs(r.x - p.x), std::abs(r.y - p.y)));
    if (std::abs(turn) <= kLevelPart * picture * extent) return 0;
    return turn > 0 ? 1 : -1;
  }
  const double det = p.w * (q.x * r.y - q.y * r.x) + q.w * (r.x * p.y - r.y * p.x) + r.w * (p.x * q.y - p.y * q.x);
  // The determinant is thickness times side times, in perspective, the square of the distance.
  const double side = std::max({std::abs(q.x - p.x), std::abs(q.y - p.y), std::abs(q.w - p.w), std::abs(r.x - p.x),
                                std::abs(r.y - p.y), std::abs(r.w - p.w)});
  const double distance = std::max({std::abs(p.w), std::abs(q.w), std::abs(r.w), std::abs(p.x), std::abs(p.y)});
  if (std::abs(det) <= kLevelPart * distance * distance * side) return 0;
  return det > 0 ? 1 : -1;
}

}  // namespace ligne::horizon
