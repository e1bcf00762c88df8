#pragma once
/// Rulings at which a surface that bends to one side goes over into one that bends to the other side.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Those of `joints` that are no inflections. The chords of two surfaces that are divided at equal angles leave their common
/// ruling at half of that angle. So where they bend to opposite sides, the strips on both sides of it lie in one plane,
/// though two surfaces meet there. Beyond both strips the facets bend alike, to opposite sides, at edges about parallel to
/// the ruling. `joints`: those of flat_joints(), indices from `first_edge` on. `normals` are those of face_normals(). O(log
/// n) for each.
std::vector<std::uint32_t> without_inflections(const Scene& scene, const Topology& topology, std::uint32_t first_edge,
                                               std::span<const glm::vec3> normals, std::span<const std::uint32_t> joints);

}  // namespace ligne
