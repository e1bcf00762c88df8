#pragma once
/// Edges at which two faces lie in one plane.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Least cosine between the normals of faces that may lie in one plane (2.6 degrees). Beyond it they do not, whatever
/// the precision.
inline constexpr double kFlatCosine = 0.999;

/// Whether a surface may be smooth across an edge, whatever its faces bend by.
inline bool may_be_smooth(const Topology& topology, std::uint32_t e) {
  constexpr std::uint16_t kNotSmooth = kEdgeManyFaces | kEdgeUnlikeWound | kEdgeSharp | kEdgeCrossing;
  return topology.edges[e].face1 != kNone && !(topology.edge_flags[e] & kNotSmooth);
}

/// The edges of an object at which two faces lie in one plane, as far as these two tell: indices from `edges.begin` on,
/// ascending. `normals` are those of face_normals(); `candidates` holds them among other edges of the topology, ascending,
/// as MeshAngles::flat does.
std::vector<std::uint32_t> flat_joints(const Scene& scene, const Topology& topology, const Object& object, EdgeRange edges,
                                       std::span<const glm::vec3> normals, std::span<const std::uint32_t> candidates);

}  // namespace ligne
