#pragma once
/// Tangent edges between two free forms, such as the sides of a fillet along a loft.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/patch_edges.hpp"

namespace ligne {

/// Sets to PatchEdge::tangent the lines of edges inside free forms across which the curvature jumps. Tessellators put rows
/// of vertices on the edges of a part, and divide a surface that bends more into narrower facets. So such a line is smooth,
/// all facets on its one side are deeper than those on the other, and they bend less. One quadric for both sides, with two
/// curvatures across the edge, tells by how much; a single edge proves nothing, but a line does. `is_line`: per edge, 1 if
/// it is another line. O(n log n) in the edges inside free forms.
void find_freeform_seams(const Scene& scene, const Topology& topology, const Patches& patches,
                         const std::vector<std::uint8_t>& is_line, std::vector<PatchEdge>& edges);

}  // namespace ligne
