#pragma once
/// Directions on a surface that strokes follow: two at each point, which cross.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "scene/form/form_mesh.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// A point of a triangle by its weights at the corners.
using Weights = std::array<double, 3>;

/// Two directions at each node, or planes that the strokes lie in.
class FormField {
 public:
  /// Unit vectors by node. The second one is that of strokes which cross the others where it is dark.
  using Directions = std::vector<std::array<Point3, 2>>;

  explicit FormField(Directions of_node) : of_node_(std::move(of_node)) {}
  /// Strokes lie in the planes y = constant and x = constant of the scene.
  static FormField of_ground() { return FormField({}); }

  /// Direction in the plane of the triangle; zero where there is none.
  Point3 at(const FormMesh& mesh, std::uint32_t triangle, const Weights& weights, bool second) const;
  /// The one of both, either way, that `along` goes on in; `second` is set to which it is.
  Point3 onward(const FormMesh& mesh, std::uint32_t triangle, const Weights& weights, const Point3& along,
                bool& second) const;

 private:
  Directions of_node_;  ///< empty: planes
};

/// The directions of principal curvature: first that in which the surface bends most. Curvatures are those of
/// [Rusinkiewicz2004]; where they differ little, as on flat parts and on spheres, directions follow those round about, as
/// crosses that any quarter turn maps to themselves [HertzmannZorin2000]. `length`: over what distance in model units
/// directions are evened out. `otherwise` gives the first direction at a node of a surface that bends nowhere; zero is
/// allowed.
FormField curvature_field(const FormMesh& mesh, double length, const std::function<Point3(std::uint32_t)>& otherwise);

/// Points of parametric surfaces with the directions of the curves through them, of any length; zero where there is none.
/// Without points the surfaces are z = f(x, y), whose curves lie in planes.
struct SurfaceCurves {
  std::vector<Point3> points;  ///< vertices of the scene
  std::vector<std::array<Point3, 2>> ways;
};

/// Those of samples, whose coordinates are multiplied by `factor` in the scene; no points where all are z = f(x, y).
SurfaceCurves surface_curves(const std::vector<SurfacePoints>& surfaces, const Point3& factor);

/// The directions of curves. Vertices that are no such points, as where a surface was cut, have those of their neighbours.
FormField curve_field(const FormMesh& mesh, const SurfaceCurves& curves);

}  // namespace ligne
