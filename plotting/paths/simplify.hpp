#pragma once
/// Fewer points for the same line.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Indices of the points that stay, ascending, the first and the last among them (Douglas, Peucker 1973, with distances from
/// the segment, not from its line): what is dropped lies within `tolerance` of the line that stays, and the line that stays
/// within `tolerance` of the one before. A closed line keeps its first point. Zero drops only points that lie exactly on the
/// segment between others.
std::vector<std::uint32_t> simplified(std::span<const Point2> line, double tolerance);

}  // namespace ligne
