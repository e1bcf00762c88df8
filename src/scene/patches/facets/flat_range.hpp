#pragma once
/// A plane, and how far points lie from it.

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "geometry/point.hpp"

namespace ligne {

/// A plane with the range of its points along the normal.
struct FlatRange {
  Point3 at{0, 0, 0}, normal{0, 0, 0};
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(const Point3& p) {
    const double height = glm::dot(p - at, normal);
    low = std::min(low, height), high = std::max(high, height);
  }
  double width() const { return high - low; }
  void turn_to_unit() {
    if (const double length = glm::length(normal); length > 0) normal /= length;
  }
  /// Moves the point of the plane to the middle of the range.
  void move_to_middle() { at += (low + high) / 2 * normal; }
};

}  // namespace ligne
