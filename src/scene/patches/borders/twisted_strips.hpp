#pragma once
/// Strips of long triangles between two curves, as tessellators make of ruled surfaces.

#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/patch_edges.hpp"

namespace ligne {

/// Sets to PatchEdge::inside the edges between the triangles of a twisted strip. Its triangles have a short side on one of
/// two curves and on the other one in turns, and follow the directions of these curves in turns as well: they fold at each
/// edge to the other side, though the ruled surface that they stand for is smooth. O(n log n).
void smooth_twisted_strips(const Scene& scene, const Topology& topology, const MeshAngles& angles,
                           std::vector<PatchEdge>& edges);

}  // namespace ligne
