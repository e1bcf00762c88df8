#pragma once
/// Borders at which the shape of a part changes by the kinds of its surfaces.

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

}  // namespace ligne
