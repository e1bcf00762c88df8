#pragma once
/// The faces round the outline of the mesh, with the normals of the smooth surface that they stand for.
///
/// Notation: v is the direction from a point of the surface to the eye, n the normal of the smooth surface, g = n . v. The
/// label of a vertex is the sign of g there. A *sector* is a run of triangles round a vertex that no border parts; a vertex
/// has one normal and one label in each of its sectors.
///
/// A normal is a mean of face normals with weights that are not negative, or that of a surface through the vertices
/// (patch_fits.hpp), which keeps to the following. Where all faces round a vertex look the same
/// way the vertex has the label of its faces, and zero sets of g run only through triangles that touch the outline of the
/// mesh. That is why a patch of two rings of triangles round that outline is all that is needed.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contours/surfaces/surface_fits.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"
#include "view/view.hpp"

namespace ligne {

/// Side i of a triangle runs from its corner i to the next one; "side 3 t + i" is that of triangle t.
struct SmoothPatch {
  /// Triangles that have no vertex in common with others, and the sectors at their corners.
  struct Run {
    std::uint32_t triangle, triangle_end, sector = 0, sector_end = 0;
  };

  std::vector<Triangle> triangles;
  std::vector<Run> runs;
  std::vector<std::int8_t> facing;     ///< per triangle: +1 when it looks at the viewer, -1 away, 0 edge on
  std::vector<std::uint32_t> across;   ///< per side: the same side of the neighbour, kNone at a border of the region
  std::vector<std::uint32_t> sector;   ///< per corner: number of its sector
  std::vector<std::uint8_t> complete;  ///< per corner: all triangles of its sector are in the patch
  std::vector<Point3> normals;         ///< per sector, unit length; zero where no face round it has an area
  std::vector<double> g;               ///< per sector
  std::vector<std::uint8_t> ruled;     ///< per sector: 1 where its normal is square to rulings (rulings.hpp)
  std::vector<std::uint32_t> fit;      ///< per sector: number of the fitted surface whose normal it has, or kNone
  std::vector<NormalTurn> turns;       ///< by that number
  const Patches* surfaces = nullptr;   ///< those that were found behind the faces of the scene; null: none

  /// Zero counts as looking at the viewer: so g is never zero at a vertex.
  bool looks_at_viewer(std::uint32_t corner) const { return g[sector[corner]] >= 0; }
};

inline std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
inline std::uint32_t last_corner(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

/// From the point to the eye; not of unit length in perspective.
Point3 to_eye(const Camera& camera, const Point3& p);

/// Where smooth regions end.
struct RegionBorders {
  double crease_degrees = 30;
  /// Per edge of the topology: kCreaseLine where a region ends; it also ends where the normals of the triangles differ by
  /// more than twice the crease angle. Null: where they differ by more than the crease angle.
  const std::vector<std::uint8_t>* creases = nullptr;
  /// The surfaces that were found behind the faces; null: none. They outlive all that is made of them.
  const Patches* surfaces = nullptr;
};

/// The outline edges of a mesh along which no region ends, in ascending order. Left out are those that have no
/// vertex near them that another one has: round a vertex inside a region there are two of them, or more, so such an edge
/// runs from border to border of its region, and is the contour itself.
std::vector<std::uint32_t> outlines_inside_regions(const Scene& scene, const Topology& topology,
                                                   std::span<const std::uint32_t> outline_edges,
                                                   const RegionBorders& borders);

/// The patch round edges inside regions. Borders of regions are creases, edges of other than two triangles,
/// those across which the windings disagree, and all edges at a vertex from whose normal a face round it differs by more
/// than the crease angle (the tip of a cone).
SmoothPatch smooth_patch(const Scene& scene, const Topology& topology, const Camera& camera,
                         std::span<const std::uint32_t> outline_edges, const RegionBorders& borders);

}  // namespace ligne
