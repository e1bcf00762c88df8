#pragma once
/// Tangent lines with gaps: borders of patches whose evidence is missing in places.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/patch_edges.hpp"

namespace ligne {

/// Follows tangent lines behind their loose ends, along borders of patches and free forms of which nothing is known, up to
/// the next line. A gap of up to half the length of the line becomes tangent. Before a gap that is longer than the
/// line, most of it is unsupported: the line becomes PatchEdge::inside, from its loose end to the next junction. A line
/// behind which no border leads to another one stays. `is_line`: per edge, 1 if it is another line. O(n log n).
void close_tangent_gaps(const Scene& scene, const Topology& topology, const Patches& patches,
                        const std::vector<std::uint8_t>& is_line, std::vector<PatchEdge>& edges);

}  // namespace ligne
