#pragma once
/// Open rims of recognised surfaces that may be refined.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// Open edges of recognised surfaces, of `curved` ones, beside which no other open edge lies: the rim of a bowl. Beside the
/// open end of a tube that a separate disk closes lies the border of the disk, and the one would leave the other.
std::vector<std::uint32_t> free_rims(const Scene& scene, const Topology& topology, const Patches& patches,
                                     std::span<const std::uint32_t> curved);

}  // namespace ligne
