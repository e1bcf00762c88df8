#pragma once
/// Lines where two colours meet on a surface.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Makes tangent lines (kTangentLine) of the edges whose two faces differ in colour or opacity, and that are no lines yet,
/// such as those around a window that is painted on a wall. Objects with colours everywhere are left alone: more than
/// four colours, which meet at more than half of the edges of two faces that are no lines. `lines`: per edge of the topology
/// (crease_lines.hpp). Takes O(n), plus O(m log m) for m materials.
void mark_color_borders(const Scene& scene, const Topology& topology, std::vector<std::uint8_t>& lines);

}  // namespace ligne
