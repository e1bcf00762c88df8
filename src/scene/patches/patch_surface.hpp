#pragma once
/// The surfaces that patches of a mesh stand for: spheres, cylinders, cones and tori.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/point.hpp"

namespace ligne {

enum class SurfaceKind : std::uint8_t { cylinder, cone, sphere, torus };

/// A surface with its parameters, in model units. Its normals point away from the axis, the centre or the middle circle.
///   cylinder  `at` a point of the axis, `radius`;
///   cone      `at` a point of the axis, `radius` the radius there, which grows by `slope` per unit along the axis;
///   sphere    `at` the centre, `radius`;
///   torus     `at` the centre, `radius` of the middle circle about the axis, `tube` the radius of the tube round it.
struct PatchSurface {
  SurfaceKind kind = SurfaceKind::cylinder;
  Point3 at{0, 0, 0};
  Point3 axis{0, 0, 1};  ///< unit length
  double radius = 0, slope = 0, tube = 0;

  /// Signed distance of a point, positive on the side to which the normals point.
  double distance(const Point3& p) const;
  /// Unit normal of the surface at its point nearest to p.
  Point3 normal(const Point3& p) const;
  /// Normal curvature near p along a tangent of unit length: above 0 where the surface bends away from its normal.
  double curvature(const Point3& p, const Point3& along) const;
  /// The larger of the absolute values of both principal curvatures near p.
  double largest_curvature(const Point3& p) const;
};

/// A point as a surface of revolution has it.
struct AxisPlace {
  Point3 out{0, 0, 0};           ///< unit vector away from the axis
  double along = 0, radius = 0;  ///< along the axis from `at`, and the distance from the axis
};

AxisPlace axis_place(const PatchSurface& surface, const Point3& p);

/// Two unit vectors that make a right-handed orthonormal frame with a unit vector, in front of it.
std::array<Point3, 2> frame_of(const Point3& axis);

/// Number of parameters of the surfaces of that kind.
std::size_t parameter_count(SurfaceKind kind);

/// A facet as fits see it.
struct FacetFrame {
  Point3 middle{0, 0, 0}, normal{0, 0, 0};
};

/// Starting values for refine_surface() from a few facets and their corners; false where there are none.
///   cylinder  the axis is the direction that the normals are most at a right angle to, the circle Kasa's [Kasa1976];
///   cone      the axis is the normal of the plane through the ends of the normals, the apex the point nearest to the
///   planes; sphere    least squares of the squared distances; torus     the axis is the line that the normals come nearest
///   to meeting [PottmannWallner2001, 4.2], the rest a circle.
bool guess_surface(SurfaceKind kind, std::span<const FacetFrame> facets, std::span<const Point3> points,
                   PatchSurface& surface);

/// Moves a surface to a least sum of the squared distances of the points [Levenberg1944, Marquardt1963]. Returns the largest
/// distance of a point then.
double refine_surface(PatchSurface& surface, std::span<const Point3> points);

}  // namespace ligne
