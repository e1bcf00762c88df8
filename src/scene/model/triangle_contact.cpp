// Two closed convex sets have no common point if a plane, or in some projection a line, lies strictly between them. The
// code below looks for such a plane or line:
//
//   plane of a triangle                     signs of plane_side()
//   plane through an edge and a side        the same: a line that has a side of a triangle on its left and another one on
//                                           its right passes the triangle by
//   line in a projection along an axis      orientation_sign(), which is exact; this distinguishes coplanar triangles
//
// So "apart" is always proven; if signs are uncertain, the answer is "not apart".

#include "scene/model/triangle_contact.hpp"

#include <cmath>

#include "geometry/predicates.hpp"

namespace ligne {
namespace {

/// Relative error bound of the determinant of three differences, as a part of the sum of the sizes of its terms
/// (Shewchuk 1997, "o3derrboundA"), and an absolute bound on the loss by underflow: four products of two differences,
/// below 2^-1074 each, times differences below 2^202 (kLargestCoordinate).
constexpr double kPlaneSideErrorBound = (7.0 + 56.0 * 0x1p-53) * 0x1p-53;
constexpr double kUnderflow = 0x1p-868;

Point2 flat(const Point3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

/// Whether the segment and the triangle have no common point in the projection along the axis.
bool apart_in_projection(const Point3& p, const Point3& q, const Corners3& t, int axis) {
  const Point2 p2 = flat(p, axis), q2 = flat(q, axis);
  const std::array<Point2, 3> c{flat(t[0], axis), flat(t[1], axis), flat(t[2], axis)};
  const int turn = orientation_sign(c[0], c[1], c[2]);
  for (int i = 0; i < 3 && turn != 0; ++i) {
    const Point2 a = c[i], b = c[(i + 1) % 3];
    if (orientation_sign(a, b, p2) * turn < 0 && orientation_sign(a, b, q2) * turn < 0) return true;
  }
  const int side = orientation_sign(p2, q2, c[0]);
  return side != 0 && orientation_sign(p2, q2, c[1]) == side && orientation_sign(p2, q2, c[2]) == side;
}

bool segment_apart(const Point3& p, const Point3& q, const Corners3& t) {
  const int of_p = plane_side(t[0], t[1], t[2], p), of_q = plane_side(t[0], t[1], t[2], q);
  if (of_p * of_q > 0) return true;
  if (of_p != 0 || of_q != 0) {
    bool left = false, right = false;
    for (int i = 0; i < 3; ++i) {
      const int side = plane_side(p, q, t[i], t[(i + 1) % 3]);
      left = left || side < 0;
      right = right || side > 0;
    }
    if (left && right) return true;
  }
  return apart_in_projection(p, q, t, 0) || apart_in_projection(p, q, t, 1) || apart_in_projection(p, q, t, 2);
}

/// Whether the corners of u from `first` on lie strictly on one side of the plane of t.
bool beside(const Corners3& t, const Corners3& u, int first) {
  const int side = plane_side(t[0], t[1], t[2], u[first]);
  for (int i = first + 1; i < 3 && side != 0; ++i) {
    if (plane_side(t[0], t[1], t[2], u[i]) != side) return false;
  }
  return side != 0;
}

/// Whether triangles with a common side are apart: in different planes, or on different sides of it in one plane.
bool apart_beyond_side(const Corners3& t, const Corners3& u) {
  if (plane_side(t[0], t[1], t[2], u[2]) != 0) return true;
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 a = flat(t[0], axis), b = flat(t[1], axis);
    if (orientation_sign(a, b, flat(t[2], axis)) * orientation_sign(a, b, flat(u[2], axis)) < 0) return true;
  }
  return false;
}

}  // namespace

int plane_side(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Point3 p = a - d, q = b - d, r = c - d;
  const double qxry = q.x * r.y, rxqy = r.x * q.y, rxpy = r.x * p.y, pxry = p.x * r.y, pxqy = p.x * q.y, qxpy = q.x * p.y;
  const double det = p.z * (qxry - rxqy) + q.z * (rxpy - pxry) + r.z * (pxqy - qxpy);
  const double size = (std::abs(qxry) + std::abs(rxqy)) * std::abs(p.z) + (std::abs(rxpy) + std::abs(pxry)) * std::abs(q.z) +
                      (std::abs(pxqy) + std::abs(qxpy)) * std::abs(r.z);
  const double bound = kPlaneSideErrorBound * size + kUnderflow;
  return det > bound ? 1 : det < -bound ? -1 : 0;
}

bool are_apart(const Corners3& t, const Corners3& u, int shared) {
  if (shared > 2) return false;
  if (shared == 2) return apart_beyond_side(t, u);
  if (beside(t, u, shared) || beside(u, t, shared)) return true;
  // Common points of two triangles other than a shared corner reach the opposite side of one of them.
  if (shared == 1) return segment_apart(t[1], t[2], u) && segment_apart(u[1], u[2], t);
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3;
    if (!segment_apart(t[i], t[k], u) || !segment_apart(u[i], u[k], t)) return false;
  }
  return true;
}

bool has_no_area(const Corners3& t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orientation_sign(flat(t[0], axis), flat(t[1], axis), flat(t[2], axis)) != 0) return false;
  }
  return true;
}

}  // namespace ligne
