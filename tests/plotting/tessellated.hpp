#pragma once
/// Circles and ellipses as polylines.

#include <algorithm>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "plotting/paths/elliptic_arc.hpp"

namespace ligne {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180;

/// Corners of an ellipse from one eccentric angle to another.
inline std::vector<Point2> tessellated(const Ellipse& ellipse, double from, double sweep, int steps) {
  std::vector<Point2> points;
  for (int i = 0; i <= steps; ++i) points.push_back(point_at(ellipse, from + sweep * i / steps));
  return points;
}

inline std::vector<Point2> closed(const Ellipse& ellipse, int steps) {
  std::vector<Point2> points = tessellated(ellipse, 0.1, 2 * kPi, steps);
  points.back() = points.front();
  return points;
}

/// Distance of a point from a segment.
inline double to_segment(Point2 p, Point2 a, Point2 b) {
  const Point2 along = b - a;
  const double length = glm::dot(along, along);
  const double t = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
  return glm::length(p - a - along * t);
}

}  // namespace ligne
