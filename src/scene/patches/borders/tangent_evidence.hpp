#pragma once
/// The evidence of a tangent line that the surfaces and faces beside an edge give.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/patch_edges.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// Whether the surfaces on both sides of an edge are of two families: planes, surfaces with straight lines, spheres, and
/// tori. The bands by which a free form is approximated are all of one family. Cylinders, spheres and tori of one radius may
/// still be bands of a bent tube, unless their corners lie on them exactly. A cone may be a row of a torus or a sphere: it
/// counts if it is no band and the corners of either face are exact. Free forms and revolved profiles are of no family.
bool are_unlike(const Scene& scene, const Patches& patches, const Edge& edge);

/// Makes the border of two unlike curved surfaces tangent where these bend alike, too, if most of it is tangent. Where a
/// tube begins to bend, the curvatures across its ring cross at two places. O(n log n).
void close_unlike_borders(const Scene& scene, const Topology& topology, const Patches& patches,
                          std::vector<PatchEdge>& edges);

/// Whether an edge is a side of a strip of a cylinder, which is kStripLength times as long as the face is wide. If the file
/// shades the edge smooth, the rules for meshes decide.
bool is_of_strip(const Scene& scene, const Topology& topology, const Patches& patches, std::uint32_t e);

/// Whether an edge lies between a plane and the free form of a constructed part, whose face is kRowLength times as long
/// there as it is wide. Rows of narrow faces follow the ruling at which a fillet without a surface ends.
bool is_of_row_at_plane(const Scene& scene, const Topology& topology, const Patches& patches, std::uint32_t e);

}  // namespace ligne
