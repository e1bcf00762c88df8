#pragma once
/// Long edges beside strips, which tell of tangent lines though they are few.

#include <cstdint>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// Whether an edge is a side of a strip of a cylinder, which is kStripLength times as long as the face is wide. If the file
/// shades the edge smooth, the rules for meshes decide.
bool is_of_strip(const Scene& scene, const Topology& topology, const Patches& patches, std::uint32_t e);

/// Whether an edge lies between a plane and the free form of a constructed part, whose face is kRowLength times as long
/// there as it is wide. Rows of narrow faces follow the ruling at which a rounding without a surface ends.
bool is_of_row_at_plane(const Scene& scene, const Topology& topology, const Patches& patches, std::uint32_t e);

}  // namespace ligne
