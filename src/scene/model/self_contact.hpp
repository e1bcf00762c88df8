#pragma once
/// Finds surfaces that touch or penetrate themselves.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Per surface: 1 if it may touch or penetrate itself, that is, if two of its triangles of different faces have a point
/// in common other than their shared vertices and edges; else 0. `surface[i]` is the number of the surface of triangle
/// i, below `surface_count`, or kNone to ignore the triangle.
///
/// The result 0 is certain: every pair of triangles was separated by signs that no rounding can reverse. If a sign is
/// uncertain, the pair counts as touching, so 1 may also mean a distance of a few units in the last place. Triangles
/// without area are ignored.
///
/// Method: a bounding box tree over each surface, split along the longest side of each box down to a few triangles, is
/// tested against itself: O(n log n) if each box meets few others. Pairs of triangles are tested by orientation
/// predicates alone (Guigue and Devillers, Fast and robust triangle-triangle overlap test using orientation predicates,
/// 2003).
std::vector<std::uint8_t> find_self_contacts(std::span<const Point3> vertices, std::span<const Triangle> triangles,
                                             std::span<const std::uint32_t> surface, std::uint32_t surface_count);

/// Side of the plane through a, b, c on which d lies: +1 if a, b, c are clockwise as seen from d, -1 if
/// counter-clockwise, 0 if d lies on the plane or so close to it that rounding could reverse the sign.
///
/// Identity: plane_side(a,b,c,d) == plane_side(b,c,a,d) == -plane_side(b,a,c,d), wherever none of them is 0.
int plane_side(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

using Corners3 = std::array<Point3, 3>;

/// Whether the triangles certainly share nothing but their first `shared` corners (0, 1 or 2), which must be equal and in
/// the same order. "Certainly" means by signs that rounding can not reverse: false may also mean too close to decide. False
/// for three shared corners.
bool are_apart(const Corners3& t, const Corners3& u, int shared);

/// Whether the three corners are exactly collinear.
bool has_no_area(const Corners3& t);

}  // namespace ligne
