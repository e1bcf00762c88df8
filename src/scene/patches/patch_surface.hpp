#pragma once
/// The surfaces that patches of a mesh are tessellated from: cylinders, cones, spheres, tori, and extruded and revolved
/// profiles.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "geometry/small_matrices.hpp"

namespace ligne {

struct SweptProfile;

enum class SurfaceKind : std::uint8_t { cylinder, cone, sphere, torus, extruded, revolved };

/// A surface with its parameters, in model units. Its normals point away from the axis, the centre or the middle
/// circle.
/// - cylinder: `at` is a point of the axis, `radius` its radius.
/// - cone: `at` is a point of the axis, `radius` the radius there, which grows by `slope` per unit along the axis.
/// - sphere: `at` is the centre, `radius` its radius.
/// - torus: `at` is the centre, `radius` the radius of the tube's middle circle, `tube` the radius of the tube.
/// - extruded: the profile moves along the axis through `at`. Its normals point to one side of the profile.
/// - revolved: the profile turns about the axis through `at`. Its normals point to one side of the profile, mostly away from
///   the axis.
struct PatchSurface {
  SurfaceKind kind = SurfaceKind::cylinder;
  Point3 at{0, 0, 0};
  Point3 axis{0, 0, 1};  ///< unit length
  double radius = 0, slope = 0, tube = 0;
  std::shared_ptr<const SweptProfile> profile{};  ///< extruded, revolved; null of others

  /// Signed distance of a point from the surface, positive on the side to which the normals point.
  double distance(const Point3& p) const { return profile ? distance_from_profile(p) : distance_of_kind(p); }
  /// Unit normal of the surface at its point nearest to p.
  Point3 normal(const Point3& p) const;
  /// Point of the surface nearest to p.
  Point3 nearest(const Point3& p) const { return p - distance(p) * normal(p); }
  /// Normal curvature near p in the direction of a unit tangent: positive where the surface bends away from its normal.
  double curvature(const Point3& p, const Point3& along) const;
  /// The larger of the absolute values of both principal curvatures near p.
  double largest_curvature(const Point3& p) const;

 private:
  double distance_from_profile(const Point3& p) const;
  double distance_of_kind(const Point3& p) const {
    const Point3 way = p - at;
    if (kind == SurfaceKind::sphere) return glm::length(way) - radius;
    // As in axis_place(), without the direction away from the axis.
    const double along = glm::dot(way, axis), from_axis = glm::length(way - along * axis), x = from_axis - radius;
    if (kind == SurfaceKind::torus) return std::sqrt(x * x + along * along) - tube;
    return kind == SurfaceKind::cone ? (x - slope * along) / std::sqrt(1 + slope * slope) : x;
  }
};

/// Whether both are cylinders that may stand for adjacent pieces of a bent tube, such as a torus.
bool are_tube_pieces(const PatchSurface& s, const PatchSurface& other);

/// A point in the cylindrical coordinates of a surface of revolution.
struct AxisPlace {
  Point3 out{0, 0, 0};           ///< unit vector from the axis to the point
  double along = 0, radius = 0;  ///< coordinate along the axis, from `at`, and distance from the axis
};

/// The place of p relative to the axis of the surface.
AxisPlace axis_place(const PatchSurface& surface, const Point3& p);

/// Two unit vectors x and y such that (x, y, axis) is a right-handed orthonormal frame. `axis` has unit length.
std::array<Point3, 2> frame_of(const Point3& axis);

/// Number of free parameters of a surface of that kind.
constexpr std::size_t parameter_count(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::cylinder:
      return 5;
    case SurfaceKind::cone:
      return 6;
    case SurfaceKind::sphere:
      return 4;
    case SurfaceKind::torus:
      return 7;
    case SurfaceKind::extruded:
    case SurfaceKind::revolved:
      return 0;  // these are not fitted
  }
  return 0;
}

/// The properties of a facet that fits use.
struct FacetFrame {
  Point3 middle, normal;  ///< centre; unit normal
};

/// Facets to which surfaces are fitted, with the sums that starting values need.
struct SurfaceSample {
  std::vector<Point3> points{};      ///< corners of the facets, each once
  std::vector<FacetFrame> frames{};  ///< normals of the surface, per facet or per edge between two of them
  Point3 middle{0, 0, 0};            ///< mean of the points
  Matrix3 squares{};                 ///< sum of the outer products of the normals with themselves
};

/// Computes starting values for refine_surface() from a few facets. Returns false if they
/// determine none.
/// - cylinder: the axis is the direction most nearly perpendicular to all normals; the circle is fitted by [Kasa1976].
/// - cone: the axis is the normal of the plane through the tips of the unit normals; the apex is the point nearest to
///   all planes of facets.
/// - sphere: an algebraic least squares fit.
/// - torus: the axis is the line that comes nearest to meeting all normal lines [PottmannWallner2001, 4.2]; the tube is
///   a circle fitted in the half plane beside the axis.
bool guess_surface(SurfaceKind kind, const SurfaceSample& sample, PatchSurface& surface);

/// Computes starting values of a torus about the axis of another surface of revolution, from points of the torus. Returns
/// false if they lie on no circle in the half plane beside the axis.
bool guess_torus_about(const PatchSurface& round, std::span<const Point3> points, PatchSurface& torus);

/// Computes starting values of a cone from a cylinder that was fitted to its points: fits a cone that touches it there, by
/// its place, ruling, curvature and angle in the midst of the points [MarshallLukacsMartin2001]. The axis and the apex of a
/// part of a cone depend on each other so strongly that refine_surface() does not come from the one to the other.
PatchSurface cone_from_cylinder(const PatchSurface& cylinder, std::span<const Point3> points);

/// Computes starting values of a cone from the quadric nearest to the points of a sample, that of the least quotient of the
/// squares of its values and of its slopes [Taubin1991]. Two of its eigenvalues are nearly equal, and the third tells the
/// axis. The ruling is the line of least squares in the half plane beside the axis. The normals of the sample choose among
/// quadrics that all pass through the points, as they do through two circles; so the result is good also where facets form
/// fans, whose normals tell little of a cone. Returns nothing if no quadric passes through all points: then they lie on no
/// cylinder, cone or sphere.
std::optional<PatchSurface> cone_from_quadric(const SurfaceSample& sample);

/// Fits the surface to the points: minimises the sum of their squared distances [Levenberg1944, Marquardt1963]. Returns
/// the largest remaining distance of a point. The fit may stop early where that will be more than `hopeless`.
double refine_surface(PatchSurface& surface, std::span<const Point3> points,
                      double hopeless = std::numeric_limits<double>::infinity());

}  // namespace ligne
