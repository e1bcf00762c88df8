#pragma once
/// Planes through the corners of faces, and how far from a plane a corner may lie.

#include <span>

#include "scene/model/scene.hpp"

namespace ligne {

/// The plane of a set of points: through a point a, the point b farthest from a, and the point c farthest from the line ab.
/// Then every point q of the set is a + s (b - a) + t (c - a) + (what is off the plane), with |s| <= 2 and |t| <= 1.
struct SpanningPlane {
  Point3 origin{0, 0, 0};
  Point3 normal{0, 0, 0};  ///< unit length; zero when the points lie on one line
  double span = 0;         ///< distance from a to b

  double distance(const Point3& q) const;  ///< signed
};

/// Plane through the points, unoriented.
SpanningPlane spanning_plane(std::span<const Point3> points);

/// Largest distance from its spanning plane that rounding gives a point of a polygon that was planar before its coordinates
/// were rounded: each coordinate is off by `precision` or less, so each point by sqrt(3) precision = e. The plane carries
/// the errors of a, b, c with the weights 1 - s - t, s, t: |1 - s - t| + |s| + |t| <= 4 + 2 + 1, and the point itself adds
/// one more: 8 e. To this comes what double arithmetic itself loses over the span of the points.
double planarity_tolerance(double precision, double span);

/// Largest distance from the chord of two points that rounding gives a third point on it: an error of the chord and one of
/// the point.
double straightness_tolerance(double precision, double span);

/// Area vector (Newell's sum, half of it) of a contour, taken from its first corner.
Point3 area_vector(const std::vector<Point3>& vertices, std::span<const std::uint32_t> contour);

}  // namespace ligne
