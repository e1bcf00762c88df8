#include "picture/hatch_patches.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "geometry/disjoint_sets.hpp"

namespace ligne {

HatchPatches hatch_patches(const Scene& scene, const Topology& topology, double crease_degrees) {
  const std::size_t face_count = scene.faces.size();
  DisjointSets smooth(face_count);
  std::vector<Point3> normals(face_count);
  for (std::uint32_t face = 0; face < face_count; ++face) normals[face] = face_normal(scene, face);
  const double cosine = std::cos(crease_degrees * std::numbers::pi / 180);
  for (std::size_t i = 0; i < topology.edges.size(); ++i) {
    const Edge& edge = topology.edges[i];
    const std::uint16_t flags = topology.edge_flags[i];
    if (edge.face0 == kNone || edge.face1 == kNone || (flags & kEdgeManyFaces)) continue;
    const double turn = glm::dot(normals[edge.face0], normals[edge.face1]);
    if ((flags & kEdgeUnlikeWound ? -turn : turn) < cosine) continue;
    smooth.join(edge.face0, edge.face1);
  }
  HatchPatches patches{std::vector<std::uint32_t>(face_count), 0};
  for (std::uint32_t face = 0; face < face_count; ++face) {
    const std::uint32_t first = smooth.find(face);
    patches.of_face[face] = first == face ? patches.count++ : patches.of_face[first];
  }
  return patches;
}

}  // namespace ligne
