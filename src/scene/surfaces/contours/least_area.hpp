#pragma once
/// Triangulation of a few corners in space over a polygon of the plane.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Cuts a polygon, counter-clockwise in x and y, into triangles that have the least area in space of all that are
/// counter-clockwise too: those of a bent strip join what is level, so that it has no folds. Returns none where there is no
/// such way. O(n^3) for n corners (Klincsek 1980).
std::vector<std::array<std::uint32_t, 3>> least_area_triangles(std::span<const Point3> corners);

}  // namespace ligne
