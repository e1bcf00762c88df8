#pragma once
/// Simplifies polylines.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Returns the indices of the points that stay, ascending, with the first and the last (Douglas, Peucker 1973, with
/// distances from the segment, not from its supporting line). The points dropped lie within `tolerance` of the new
/// line, and the new line within `tolerance` of the old one. A closed line keeps its first point. A tolerance of zero
/// drops only points that lie exactly on the segment between others.
///
/// Each new segment has at least the fraction 1 - `most_lost` of the length that it replaces, and so has the whole
/// line. Corners of small curves stay round, and a closed line, however small, does not become a point.
std::vector<std::uint32_t> simplified(std::span<const Point2> line, double tolerance, double most_lost = 1);

}  // namespace ligne
