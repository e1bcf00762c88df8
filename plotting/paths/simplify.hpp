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
///
/// Each segment is at least 1 - `most_lost` as long as the part of the line that it stands for, so the whole is too: corners
/// of small curves stay round, and a closed line, however small, does not become a point.
std::vector<std::uint32_t> simplified(std::span<const Point2> line, double tolerance, double most_lost = 1);

}  // namespace ligne
