#include "scene/model/face_shape.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ligne {

bool is_convex_face(const Scene& scene, std::uint32_t face, double tolerance) {
  if (scene.faces.contour_count(face) > 1) return false;
  const auto corners = scene.faces.contour(face, 0);
  const std::size_t n = corners.size();
  if (n == 3) return true;
  const Point3 normal = face_normal(scene, face);
  const auto at = [&](std::size_t i) { return scene.vertices[corners[i % n]]; };
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 in = at(i + 1) - at(i), out = at(i + 2) - at(i + 1);
    // The turn is the length of one side times the distance of the other's end from its line.
    const double longer = std::max(glm::length(in), glm::length(out));
    if (glm::dot(normal, glm::cross(in, out)) < -tolerance * longer) return false;
  }
  return true;
}

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
