#pragma once
/// Whether bodies can be refined without regard to each other.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// Whether no two bodies of a scene, faces connected by edges, touch along a surface that is refined, and there are few of
/// them. Surfaces that touch, such as a pin in its bore, would penetrate each other if each got vertices of its own. Bodies
/// may lie apart, in each other, or penetrate each other at an angle. `levels`: per patch, above 0 if it is refined.
bool bodies_lie_apart(const Scene& scene, const Topology& topology, const Patches& patches,
                      const std::vector<std::uint8_t>& levels);

/// Whether a scene has so few objects that bodies_lie_apart() may hold: each with faces has a body of its own.
bool has_few_objects(const Scene& scene);

}  // namespace ligne
