#pragma once
/// Surfaces as triangle meshes, for the visibility methods that draw scenes.
///
/// Every cell of the grid of samples becomes two triangles, cut by the diagonal from its corner (i+1, j) to (i, j+1), low x
/// and high y to high x and low y:
///
///     (i, j+1) ---- (i+1, j+1)
///         |  \           |
///         |     \        |
///         |        \     |
///       (i, j) ------ (i+1, j)
///
/// Cells with a hole at a corner are left out. Edges along rows and columns that are curves carry kCornerCurve.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// A mesh before its heights are scaled. Triangles are wound counter-clockwise in the plane of the parameters (seen from
/// above, for z = f(x, y)).
struct SurfaceMesh {
  /// Flags of the edge from a corner to the next: CornerFlag kCornerCurve and kCornerContour, and the outward direction
  /// if the edge is on the outer rim of the grid's surface.
  enum Flag : std::uint8_t { kRimBottom = 8, kRimRight = 32, kRimTop = 64, kRimLeft = 128 };

  std::string name{};
  bool from_formula = false;
  std::vector<Point3> vertices{};  ///< some may belong to no triangle
  std::vector<std::array<std::uint32_t, 3>> triangles{};
  std::vector<std::array<std::uint8_t, 3>> flags{};
};

/// Makes the mesh of a surface. Where a parametric surface closes or runs into a pole, samples within the rounding of
/// their formulas become one vertex, and triangles that collapse are dropped.
SurfaceMesh make_surface_mesh(const SurfacePoints& surface);

/// Keeps the part at heights from `low` to `high`, both included. Triangles and their curves are cut along the two
/// planes. The new edges are borders. A cut edge has the same new vertex in both of its triangles.
void clip_heights(SurfaceMesh& mesh, double low, double high);

/// Cuts the triangles along the planes of the heights `levels` (ascending, before scaling). The new edges are contour
/// lines, and so is an edge in a plane with a face below it. A vertex within the rounding of a formula
/// (kFormulaRounding) of a level counts as at that level, and keeps its position. Throws InputError if there would be
/// more than 12 million triangles.
void cut_contours(SurfaceMesh& mesh, std::span<const double> levels);

/// The smallest and the largest height of the triangles; nothing if there are none.
std::optional<std::array<double, 2>> height_range(std::span<const SurfaceMesh> meshes);

/// A scene with one object per mesh, z up, coordinates multiplied by `factor`. With `base` (before scaling, not above
/// any height), every mesh also gets upright walls from its outer rim down to that height: one object for each of the
/// four directions, so that walls have borders where two meet and at the base. Throws InputError if a coordinate is too
/// large to compute with.
Scene surface_scene(std::span<const SurfaceMesh> meshes, const Point3& factor, std::optional<double> base);

}  // namespace ligne
