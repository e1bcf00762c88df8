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
  /// Flags of the edge from a corner to the next: CornerFlag kCornerCurve and kCornerContour, and, on the outer rim of what
  /// there is of the grid, which way is out.
  enum Flag : std::uint8_t { kRimBottom = 8, kRimRight = 32, kRimTop = 64, kRimLeft = 128 };

  std::string name;
  bool from_formula = false;
  std::vector<Point3> vertices;  ///< some may be of no triangle
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint8_t, 3>> flags;
};

/// Where a parametric surface closes, or runs into a pole, samples that lie within the rounding of their formulas become one
/// vertex; triangles that collapse by that are left out.
SurfaceMesh make_surface_mesh(const SurfacePoints& surface);

/// Keeps what lies at heights from `low` to `high`, both included: triangles are cut along the two planes, and curves with
/// them. The new edges are borders. A cut edge has the same new vertex in both of its triangles.
void clip_heights(SurfaceMesh& mesh, double low, double high);

/// Cuts the triangles along the planes of the heights `levels` (ascending, before scaling); the new edges are contour lines.
/// So is an edge that lies in a plane with a face below it. A vertex that is within the rounding of a formula
/// (kFormulaRounding) of a level counts as at that level, and keeps its place. Throws InputError when there would be more
/// than 12 million triangles.
void cut_contours(SurfaceMesh& mesh, std::span<const double> levels);

/// The least and the greatest height of the triangles, or nothing.
std::optional<std::array<double, 2>> height_range(std::span<const SurfaceMesh> meshes);

/// A scene with an object for each mesh, z up, coordinates multiplied by `factor`. With `base` (before scaling, not above
/// any height) every mesh also gets upright walls from its outer rim down to that height: one object for each of the four
/// directions, so that where two meet, and at the base, the walls have borders. Throws InputError when a coordinate is too
/// large to compute with.
Scene surface_scene(std::span<const SurfaceMesh> meshes, const Point3& factor, std::optional<double> base);

}  // namespace ligne
