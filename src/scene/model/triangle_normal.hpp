#pragma once
/// The normal of a triangle, inline for loops over many triangles.

#include <glm/geometric.hpp>

#include "geometry/point.hpp"

namespace ligne {

/// Unit normal of the triangle a, b, c; zero if it has no area. Equal to face_normal() bit for bit.
inline Point3 triangle_normal(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 sum = Point3{0, 0, 0} + glm::cross(b - a, c - a);  // no negative zeros
  const double length = glm::length(sum);
  return length > 0 ? sum / length : Point3{0, 0, 0};
}

}  // namespace ligne
