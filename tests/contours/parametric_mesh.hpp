#pragma once
/// Uneven meshes of parametric surfaces, and the contours that these surfaces have.

#include "drawing/drawing.hpp"
#include "scene/model/scene.hpp"
#include "support/standard.hpp"
#include "view/view.hpp"

namespace ligne::test {

/// All vertices and faces as the only object, exact to a rounding.
Scene as_one_object(Scene scene);

/// The view along a direction, on A4 in landscape with a margin of 10 mm.
View view_along(const Scene& scene, const Point3& direction);

/// A surface that is closed in both parameters, which run from 0 to 1.
struct ParametricSurface {
  const char* name;
  std::function<Point3(double u, double v)> at;

  Point3 normal(double u, double v) const;  ///< not of unit length; outwards
};

/// A torus, one of changing width, one bent like a saddle, an oval one, and an oval one that is tilted and of changing
/// width.
std::vector<ParametricSurface> test_surfaces();

/// 2 x rows x columns triangles. Vertices lie on the surface, up to `jitter` cells beside the place of the grid.
Scene uneven_mesh(const ParametricSurface& surface, int columns, int rows, double jitter, std::uint32_t seed);

/// The contours of the surface itself on the page, in short pieces.
Polylines true_contours(const ParametricSurface& surface, const View& view, int columns, int rows);

/// The outlines of a scene as clear lines draw them.
struct DrawnOutlines {
  View view;
  Polylines lines;
};
/// `by_angle`: smooth regions end at edges above the crease angle; otherwise only where the mesh ends.
DrawnOutlines draw_outlines(const Scene& scene, const Point3& direction, bool smooth = true, bool by_angle = false);

/// The convex hull of points in general position, in triangles. Takes time proportional to the square of their number.
Scene convex_hull(const std::vector<Point3>& points);

/// A convex body with long and short triangles side by side, as simplified parts have them: the hull of `count` points by
/// chance on the roundings at the corners of a tapered box.
Scene rounded_hull(int count, std::uint32_t seed);

}  // namespace ligne::test
