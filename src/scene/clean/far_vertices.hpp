#pragma once
/// Finds vertices so far out that the rest of a model is a dot beside them.

#include <cstddef>
#include <span>

#include "geometry/point.hpp"

namespace ligne {

/// Ratio of the largest coordinates of a far vertex and of a usual one. On the largest page, the rest of the model is then
/// smaller than a pen is wide.
inline constexpr double kFarRatio = 1e6;

struct FarVertices {
  std::size_t count = 0;
  std::size_t farthest = 0;  ///< the vertex with the largest coordinate, if there are any
  double usual = 0;          ///< median of the largest coordinates of vertices, without those at the origin
};

/// The vertices whose largest coordinate is more than kFarRatio times the median. The median is that of an even sample.
/// Coordinates must be finite.
FarVertices find_far_vertices(std::span<const Point3> vertices);

}  // namespace ligne
