#pragma once
/// Tangent lines without detours round a few triangles.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/patch_edges.hpp"

namespace ligne {

/// Leads tangent lines straight past a few triangles that were taken for a part of the wrong side: where a line goes to and
/// fro, and one edge joins the ends of this detour, the edge takes its place. Along a curve, whose corners all lie on the
/// edge of a part, such an edge would turn by as much. `is_line`: per edge, 1 if it is another line. O(n log n) in the
/// tangent edges.
void straighten_tangents(const Scene& scene, const Topology& topology, const std::vector<std::uint8_t>& is_line,
                         std::vector<PatchEdge>& edges);

}  // namespace ligne
