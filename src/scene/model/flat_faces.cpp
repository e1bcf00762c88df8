#include "scene/model/flat_faces.hpp"

#include <glm/geometric.hpp>

#include "base/no_index.hpp"

namespace ligne {

std::unordered_map<std::uint32_t, LongestNeighbour> longest_neighbours(const Scene& scene, const Topology& topology,
                                                                       const std::vector<std::uint8_t>& flat,
                                                                       FlatNeighbours flat_neighbours) {
  std::unordered_map<std::uint32_t, LongestNeighbour> neighbours;
  const auto offer = [&](std::uint32_t face, std::uint32_t other, std::size_t e) {
    if (!flat[face] || (flat[other] && flat_neighbours == FlatNeighbours::passed_over)) return;
    const Edge& edge = topology.edges[e];
    const double length = glm::distance(scene.vertices[edge.v0], scene.vertices[edge.v1]);
    LongestNeighbour& best = neighbours[face];
    if (length > best.length) best = {length, other, (topology.edge_flags[e] & kEdgeUnlikeWound) != 0};
  };
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    if (edge.face1 == kNone) continue;
    offer(edge.face0, edge.face1, e);
    offer(edge.face1, edge.face0, e);
  }
  return neighbours;
}

}  // namespace ligne
