#pragma once
/// Surfaces that can not be refined without regard to other bodies.

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/find_patches.hpp"
#include "scene/patches/refine/split_triangles.hpp"

namespace ligne {

/// The faces of each body of a scene. A body is a set of faces connected by edges.
using Bodies = std::vector<std::vector<std::uint32_t>>;

/// The bodies of a scene, if there are few of them.
std::optional<Bodies> find_few_bodies(const Scene& scene, const Topology& topology);

/// Leaves the surfaces along which bodies touch as they are: a pin and its bore would penetrate each other if each got
/// vertices of its own. Bodies may lie apart, in each other, or penetrate each other at an angle.
/// `levels.of_patch` of these surfaces, and of those that are refined with them, becomes 0.
void block_touching(const Scene& scene, const Bodies& bodies, const Patches& patches, EdgeLevels& levels);

/// Whether a scene has so few objects that it may have few bodies: each object with faces has a body of its own.
bool has_few_objects(const Scene& scene);

}  // namespace ligne
