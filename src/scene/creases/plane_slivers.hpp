#pragma once
/// Slivers in planes.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Gives slivers that lie in a plane the normal of that plane, and returns the edges at which they border on others, not
/// sorted. A sliver at the edge of two planes has taken its normal from one of them (face_normals()), but may belong to the
/// other: then the edge lies on its other side. `plane_edges`: see Patches.
std::vector<std::uint32_t> turn_plane_slivers(const Scene& scene, const Topology& topology,
                                              std::span<const std::uint32_t> plane_edges, std::vector<glm::vec3>& normals);

}  // namespace ligne
