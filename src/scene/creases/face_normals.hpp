#pragma once
/// Normals of faces, also of those that have none of their own.

#include <glm/vec3.hpp>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Unit normals of all faces, in the direction of their winding. A triangle that is no higher than its coordinates are
/// precise has a normal by chance: it takes that of its neighbour across its longest edge, and so do neighbours of such,
/// from the next face that has a normal. Zero for those that have no such neighbour.
std::vector<glm::vec3> face_normals(const Scene& scene, const Topology& topology);

}  // namespace ligne
