#pragma once
/// Planes through the corners of faces, and tolerances for the distance of corners from a plane.

#include <limits>
#include <span>

#include "scene/model/scene.hpp"

namespace ligne {

/// The plane of a set of points: through a point a, the point b farthest from a, and the point c farthest from the line
/// ab. Then every point q of the set is a + s (b - a) + t (c - a) plus a vector along the normal, with |s| <= 2 and |t|
/// <= 1.
struct SpanningPlane {
  Point3 origin{0, 0, 0};
  Point3 normal{0, 0, 0};  ///< unit length; zero if the points are collinear
  double span = 0;         ///< distance from a to b

  double distance(const Point3& q) const;  ///< signed
};

/// The spanning plane of the points. The sign of its normal is arbitrary.
SpanningPlane spanning_plane(std::span<const Point3> points);

inline constexpr double kSqrt3 = 1.7320508075688772;

/// Error of double arithmetic over a span.
inline double arithmetic_error(double span) {
  // Number of roundings of one unit in the last place of the span, from coordinates to the distance from a plane:
  // differences, two projections, the cross product and the dot product.
  constexpr double kArithmeticRoundings = 16;
  return kArithmeticRoundings * std::numeric_limits<double>::epsilon() * span;
}

/// Largest distance of a corner from the spanning plane of a polygon that was planar before its coordinates were
/// rounded. The error of a coordinate is at most `precision`, so that of a point is at most e = sqrt(3) precision. The
/// plane has the errors of a, b, c with the weights 1 - s - t, s, t, where |1 - s - t| + |s| + |t| <= 4 + 2 + 1. The
/// point itself adds one more e: 8 e in total. The rounding of double arithmetic over `span` is added.
inline double planarity_tolerance(double precision, double span) {
  constexpr double kPlaneErrors = 8;
  return kPlaneErrors * kSqrt3 * precision + arithmetic_error(span);
}

/// Largest distance of a point from the chord of two others if the three were collinear before rounding: the error of
/// the chord plus that of the point.
inline double straightness_tolerance(double precision, double span) {
  constexpr double kLineErrors = 2;
  return kLineErrors * kSqrt3 * precision + arithmetic_error(span);
}

/// Whether the corners of a triangle were perhaps collinear before rounding, so that its normal is a matter of chance.
bool is_sliver(const Point3& a, const Point3& b, const Point3& c, double precision);

/// Whether a face is such a triangle, at the precision of its object.
bool is_sliver_face(const Scene& scene, std::uint32_t face);

/// Area vector of a contour: its area times its unit normal, by Newell's sum relative to its first corner.
Point3 area_vector(const std::vector<Point3>& vertices, std::span<const std::uint32_t> contour);

}  // namespace ligne
