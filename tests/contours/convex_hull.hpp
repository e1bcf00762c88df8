#pragma once
/// Convex bodies with long and short triangles side by side, as simplified parts have them.

#include "scene/model/scene.hpp"
#include "support/standard.hpp"

namespace ligne::test {

/// The convex hull of points in general position, in triangles. Takes time proportional to the square of their number.
Scene convex_hull(const std::vector<Point3>& points);

/// The hull of `count` points by chance on the roundings at the corners of a tapered box.
Scene rounded_hull(int count, std::uint32_t seed);

}  // namespace ligne::test
