#pragma once
/// Directions on a surface that strokes follow: two crossing directions at each point.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "scene/form/form_mesh.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// A point of a triangle, as weights of its corners.
using Weights = std::array<double, 3>;

/// Two directions at each node, or two families of planes that contain the strokes.
class FormField {
 public:
  /// Unit vectors by node. The second direction is that of the strokes that cross the others in dark places.
  using Directions = std::vector<std::array<Point3, 2>>;

  explicit FormField(Directions of_node) : of_node_(std::move(of_node)) {}
  /// A field whose strokes lie in the planes y = constant and x = constant of the scene.
  static FormField of_ground() { return FormField({}); }

  /// Returns a direction in the plane of the triangle; zero if there is none.
  Point3 at(const FormMesh& mesh, std::uint32_t triangle, const Weights& weights, bool second) const;
  /// Returns the direction of the field, or its opposite, that continues `along` best. Sets `second` if it is the
  /// second one.
  Point3 onward(const FormMesh& mesh, std::uint32_t triangle, const Weights& weights, const Point3& along,
                bool& second) const;

 private:
  Directions of_node_;  ///< empty: planes
};

/// The directions of principal curvature, the first being the one in which the surface bends most. Curvatures are
/// computed as in [Rusinkiewicz2004]. Where they differ little, as on flat parts and spheres, directions follow those
/// around, as crosses that any quarter turn maps to themselves [HertzmannZorin2000]. `length` is the smoothing distance
/// in model units. `otherwise` returns the first direction at a node of a surface without curvature; zero is allowed.
FormField curvature_field(const FormMesh& mesh, double length, const std::function<Point3(std::uint32_t)>& otherwise);

/// Points of parametric surfaces with the directions of the two curves through each, of any length; zero if there is
/// none. Without points, the surfaces are z = f(x, y), whose curves lie in planes.
struct SurfaceCurves {
  std::vector<Point3> points;  ///< vertices of the scene
  std::vector<std::array<Point3, 2>> ways;
};

/// Curves of samples, whose coordinates are multiplied by `factor` in the scene; no points if all surfaces are z = f(x,
/// y).
SurfaceCurves surface_curves(const std::vector<SurfacePoints>& surfaces, const Point3& factor);

/// The directions of curves. A vertex that is no such point, as at a cut of a surface, gets the directions of its
/// neighbours.
FormField curve_field(const FormMesh& mesh, const SurfaceCurves& curves);

}  // namespace ligne
