#pragma once
/// Triangulates a few corners in space whose projection is a polygon.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Cuts a polygon, counter-clockwise in x and y, into counter-clockwise triangles with the smallest total area in
/// space. On a bent strip these connect corners at equal heights, so that it has no folds. Returns no triangles if
/// there is no such triangulation. O(n^3) for n corners (Klincsek 1980).
std::vector<std::array<std::uint32_t, 3>> least_area_triangles(std::span<const Point3> corners);

}  // namespace ligne
