#pragma once
/// The length of a path, and whether it is closed.

#include <cstddef>
#include <span>

#include <glm/geometric.hpp>

#include "geometry/point.hpp"

namespace ligne {

/// The length of a polyline, in its own units.
inline double path_length(std::span<const Point2> line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += glm::distance(line[i - 1], line[i]);
  return sum;
}

/// Whether a polyline returns to its first point.
inline bool is_loop(std::span<const Point2> line) { return line.size() > 2 && line.front() == line.back(); }

}  // namespace ligne
