#pragma once
/// Makes triangulations less slender.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Flips edges between two triangles until each is locally Delaunay (Lawson 1977: the constrained Delaunay
/// triangulation), or until a bound on the number of flips is reached, which is linear in the number of triangles. The
/// triangles cover the same area as before. `triangles` are triples of positions, counter-clockwise, and do not
/// overlap.
void flip_to_delaunay(const std::vector<Point2>& positions, std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace ligne
