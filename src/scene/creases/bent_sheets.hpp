#pragma once
/// Edges of more than two faces.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Per edge of more than two faces, in their order, 1 where it is seen: of all faces that have the edge, the directions of
/// two from it are neither alike nor opposite; or all are alike, and the sheets end there. `crease_cosine` is that of the
/// angle by which directions differ.
std::vector<std::uint8_t> bent_sheets(const Scene& scene, const Topology& topology, float crease_cosine);

}  // namespace ligne
