#pragma once
/// Whether bodies can be refined without regard to each other.

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// The faces of each body of a scene. A body is a set of faces connected by edges.
using Bodies = std::vector<std::vector<std::uint32_t>>;

/// The bodies of a scene, if there are few of them.
std::optional<Bodies> find_few_bodies(const Scene& scene, const Topology& topology);

/// Whether no two bodies touch along a surface that is refined. Surfaces that touch, such as a pin in its bore, would
/// penetrate each other if each got vertices of its own. Bodies may lie apart, in each other, or penetrate each other at an
/// angle. `levels`: per patch, above 0 if it is refined.
bool bodies_lie_apart(const Scene& scene, const Bodies& bodies, const Patches& patches,
                      const std::vector<std::uint8_t>& levels);

/// Whether a scene has so few objects that it may have few bodies: each object with faces has a body of its own.
bool has_few_objects(const Scene& scene);

}  // namespace ligne
