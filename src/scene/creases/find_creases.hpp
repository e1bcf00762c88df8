#pragma once
/// Finds the creases of the shape that a mesh approximates.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "scene/creases/crease_lines.hpp"
#include "scene/creases/sheet_edges.hpp"
#include "scene/creases/trace_creases.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/patch_edges.hpp"

namespace ligne {

/// Smallest angles of creases, in degrees.
struct CreaseAngles {
  double faces = 30;                        ///< between the normals of faces without a recognised surface
  double surfaces = kSurfaceCreaseDegrees;  ///< between the normals of recognised surfaces where they meet
};

struct Creases {
  std::vector<std::uint8_t> lines;     ///< per edge of the topology: kCreaseLine, or 0
  std::vector<PatchEdge> patch_edges;  ///< per edge of the topology
  Patches patches;                     ///< the recognised surfaces
  std::vector<WallEdge> walls;         ///< creases that are visible from one side only
  std::vector<FoldSheet> folds;        ///< faces at edges of more than two that are no creases, see SheetEdges
  std::vector<ScanObject> scans;       ///< objects whose creases were traced, ascending
  TriangleShapes shapes;               ///< of the scene; only if all its faces are triangles
  std::size_t decimated = 0;           ///< those of them that are decimated parts

  // Differences from the simple rule that an edge is a crease if the angle of its faces exceeds the limit or if it has
  // more than two faces. Numbers of edges:
  std::size_t smooth_by_file = 0;    ///< removed, since the file says that the surface is smooth across them
  std::size_t sharp_by_file = 0;     ///< added, since the file says that it is not
  std::size_t inside_surfaces = 0;   ///< removed inside one surface, or where two surfaces join smoothly
  std::size_t between_surfaces = 0;  ///< added where surfaces meet at an angle
  std::size_t untraced = 0;          ///< removed from scans, since they lie on no clean line
  std::size_t traced = 0;            ///< added to scans, since they lie on a clean line
  std::size_t continued = 0;         ///< added between two creases that they join
  std::size_t fading = 0;            ///< removed, since they end in the middle of a surface and do not stand out
  std::size_t loose = 0;             ///< removed, since they end freely and are short
  std::size_t spurs = 0;             ///< removed, since they project from a crease
  std::size_t short_chains = 0;      ///< removed with chains that are short, weak and open
  double short_length = 0;           ///< total length of these chains, model units
  std::size_t straight_sheets = 0;   ///< removed, since they have more than two faces but no angle between them
};

/// Finds the creases of a scene after finish_scene() (docs/clear-lines.md, "Creases"). The angle of an edge is the
/// angle between the normals of its faces.
///
/// 1. Edges that the file marks follow it. A smooth edge (kEdgeSmooth) is a crease only above kSurelySharp, a sharp
///    edge (kEdgeSharp) already above half of `angles.faces`. The middle edge of a narrow fillet is a crease if the
///    angle between the wide sides of the fillet is large enough.
/// 2. Other edges are creases if their angle exceeds `angles.faces`. An edge of more than two faces is a crease if two
///    of them form an angle.
/// 3. Edges inside a recognised surface (patches/find_patches.hpp) are not creases, nor are edges where surfaces join
///    smoothly. Where surfaces meet at an angle there is a crease, whatever the angle of the edge.
/// 4. A crease that ends is continued in its direction over edges above half of `angles.faces`, if that leads to
///    another crease and is not longer than either of the two.
/// 5. Creases that end in the middle of a surface are cut back, or removed, where they do not stand out
///    (fading_creases.hpp).
/// 6. Short lines with two free ends are removed, and runs of smooth edges with one (loose_creases.hpp).
/// 7. Spurs are removed: single edges, shorter than 1/64 of their object, that branch off from a crease. So are
///    connected creases with a total length below 1/16 of their object that end in the middle of a surface. Edges above
///    `angles.faces` + 20 degrees, edges marked as sharp, and everything connected to them stay.
///
/// Edges that the file hides or that triangulation made are not creases. A face without area, or one that is no higher
/// than the precision of its coordinates, takes the normal of its neighbour across its longest edge.
Creases find_creases(const Scene& scene, const Topology& topology, const CreaseAngles& angles);

/// find_creases() in two steps: finds surfaces and bends, with all threads. The result, to be called once, decides on the
/// creases, mostly with the calling thread alone. The scene and its topology must outlive it.
std::function<Creases()> search_creases(const Scene& scene, const Topology& topology, const CreaseAngles& angles);

}  // namespace ligne
