#pragma once
/// Normals of faces, including slivers.

#include <glm/vec3.hpp>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Unit normals of all faces, in the direction of their winding. A triangle no higher than the precision of its
/// coordinates has a random normal, so it takes that of its neighbour across its longest edge. If that is such a sliver
/// too, the chain of longest edges is followed to the next face that has a normal. If it finds none, the triangle keeps
/// its own normal. Zero without a neighbour or without area.
std::vector<glm::vec3> face_normals(const Scene& scene, const Topology& topology);

}  // namespace ligne
