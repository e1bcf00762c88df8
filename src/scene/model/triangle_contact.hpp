#pragma once
/// Whether two triangles in space meet.

#include <array>

#include "geometry/point.hpp"

namespace ligne {

/// Side of the plane through a, b, c on which d lies: +1 when a, b, c run clockwise as seen from d, -1 when they run
/// counter-clockwise, 0 when d lies on the plane, or so near to it that rounding could turn the sign.
///
/// Identity: plane_side(a,b,c,d) == plane_side(b,c,a,d) == -plane_side(b,a,c,d), wherever none of them is 0.
int plane_side(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

using Corners3 = std::array<Point3, 3>;

/// Whether the triangles are certain to have no more in common than their first `shared` corners, which are those of both,
/// in the same order: nothing, a corner, or a side. False for three shared corners. "Certain": by signs that rounding can
/// not turn; of triangles that are nearer than that nothing is said.
bool are_apart(const Corners3& t, const Corners3& u, int shared);

/// Whether all three corners lie on a line, exactly.
bool has_no_area(const Corners3& t);

}  // namespace ligne
