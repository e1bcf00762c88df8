#pragma once
/// Intersection test of two triangles in space.

#include <array>

#include "geometry/point.hpp"

namespace ligne {

/// Side of the plane through a, b, c on which d lies: +1 if a, b, c are clockwise as seen from d, -1 if
/// counter-clockwise, 0 if d lies on the plane or so close to it that rounding could reverse the sign.
///
/// Identity: plane_side(a,b,c,d) == plane_side(b,c,a,d) == -plane_side(b,a,c,d), wherever none of them is 0.
int plane_side(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

using Corners3 = std::array<Point3, 3>;

/// Whether the triangles certainly have nothing in common but their first `shared` corners, which must be equal and in
/// the same order: no point, one corner, or one side. False for three shared corners. "Certainly" means by signs that
/// rounding can not reverse; false may also mean that the triangles are too close to decide.
bool are_apart(const Corners3& t, const Corners3& u, int shared);

/// Whether the three corners are exactly collinear.
bool has_no_area(const Corners3& t);

}  // namespace ligne
