#pragma once
/// The triangles around the outline of the mesh, with the normals of the smooth surface that the mesh approximates.
///
/// Notation: v is the direction from a point of the surface to the eye, n the normal of the smooth surface, g = n . v.
/// The label of a vertex is the sign of g there. A *sector* is a set of triangles around a vertex that no border of a
/// region separates; a vertex has one normal and one label in each of its sectors.
///
/// A normal is a mean of face normals with non-negative weights, or the normal of a surface fitted to the vertices
/// (fit_surfaces()). Both have this property: if all faces around a vertex face the same way, the vertex has the label
/// of its faces. So zero sets of g run only through triangles that touch the outline of the mesh, and a patch of two
/// rings of triangles around that outline suffices.

#include <cstdint>
#include <span>
#include <vector>

#include "contours/surfaces/surface_fits.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"
#include "view/view.hpp"

namespace ligne {

/// A part of a mesh as triangles. Side i of a triangle runs from its corner i to the next one; side i of triangle t has
/// the index 3 t + i.
struct SmoothPatch {
  /// A range of triangles that share no vertex with triangles of other ranges, and the range of their sectors.
  struct Run {
    std::uint32_t triangle, triangle_end, sector = 0, sector_end = 0;
  };

  std::vector<Triangle> triangles;
  std::vector<Run> runs;
  std::vector<std::int8_t> facing;     ///< per triangle: +1 if it faces the viewer, -1 if it faces away, 0 if edge on
  std::vector<std::uint32_t> across;   ///< per side: index of the same side in the neighbour, kNone at a border
  std::vector<std::uint32_t> sector;   ///< per corner: index of its sector
  std::vector<std::uint8_t> complete;  ///< per corner: 1 if all triangles of its sector are in the patch
  std::vector<Point3> normals;         ///< per sector, unit length; zero if no face around it has an area
  std::vector<double> g;               ///< per sector
  std::vector<std::uint8_t> ruled;     ///< per sector: 1 if its normal is perpendicular to rulings (rulings.hpp)
  std::vector<std::uint32_t> fit;      ///< per sector: index into `turns` if its normal comes from a fit, else kNone
  std::vector<NormalTurn> turns;       ///< derivatives of fitted normals
  const Patches* surfaces = nullptr;   ///< the surfaces recognised behind the mesh; null: none

  /// Whether the smooth surface faces the viewer at a corner. g = 0 counts as facing, so g is never zero at a vertex.
  bool looks_at_viewer(std::uint32_t corner) const { return g[sector[corner]] >= 0; }
};

inline std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
inline std::uint32_t previous_corner(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

/// Vector from p to the eye; of unit length only in parallel projection.
Point3 to_eye(const Camera& camera, const Point3& p);

/// Where smooth regions end.
struct RegionBorders {
  double crease_degrees = 30;
  /// Per edge of the topology: kCreaseLine if a region ends there. A region then also ends where the normals of
  /// adjacent triangles differ by more than twice the crease angle. If null, it ends where they differ by more than the
  /// crease angle.
  const std::vector<std::uint8_t>* creases = nullptr;
  /// The surfaces recognised behind the mesh; null: none. They must outlive everything that is made from these borders.
  const Patches* surfaces = nullptr;
};

/// The outline edges that lie inside regions, ascending. An edge that shares no vertex inside its region with another
/// such edge is omitted: since an interior vertex has none or at least two of them, it runs from border to border of
/// its region, and is the contour itself.
std::vector<std::uint32_t> outlines_inside_regions(const Scene& scene, const Topology& topology,
                                                   std::span<const std::uint32_t> outline_edges,
                                                   const RegionBorders& borders);

/// The patch around edges inside regions. Borders of regions are: creases; edges that do not have exactly two
/// triangles; edges across which the windings disagree; and all edges at a vertex whose normal differs by more than the
/// crease angle from the normal of a face around it (the tip of a cone).
SmoothPatch smooth_patch(const Scene& scene, const Topology& topology, const Camera& camera,
                         std::span<const std::uint32_t> outline_edges, const RegionBorders& borders);

/// Fits a surface at each sector beside the zero set of g, to the vertices of two rings within its region, and stores
/// its normal, the derivative of the normal, and g. A sector keeps its mean of face normals if the fit fails, or if all
/// its faces face one way and the fitted normal the other way. So the zero set of g stays on triangles that touch the
/// outline of the mesh.
void fit_surfaces(const Scene& scene, const Camera& camera, SmoothPatch& patch);

}  // namespace ligne
