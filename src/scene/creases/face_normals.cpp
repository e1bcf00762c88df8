#include "scene/creases/face_normals.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "geometry/parallel.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

/// Adjustable: how far slivers are followed to a face that has a normal.
constexpr int kLongestChain = 8;

/// As face_normal(), and zero for slivers.
Point3 own_normal(const Scene& scene, const Object& object, std::uint32_t f) {
  const auto contour = scene.faces.contour(f, 0);
  if (contour.size() != 3) return face_normal(scene, f);
  const Point3 &a = scene.vertices[contour[0]], &b = scene.vertices[contour[1]], &c = scene.vertices[contour[2]];
  const Point3 ab = b - a, ac = c - a, bc = c - b;
  const Point3 area = glm::cross(ab, ac);
  const double longest = std::sqrt(std::max({glm::dot(ab, ab), glm::dot(bc, bc), glm::dot(ac, ac)}));
  const double length = glm::length(area);
  return length <= straightness_tolerance(object.precision, longest) * longest ? Point3{0, 0, 0} : area / length;
}

/// The normals that faces without one take from their neighbours across their longest edges.
void take_from_neighbours(const Scene& scene, const Topology& topology, std::vector<glm::vec3>& normals) {
  struct Neighbour {
    double length = -1;
    std::uint32_t face = kNone;
    bool turned = false;
  };
  std::unordered_map<std::uint32_t, Neighbour> neighbours;
  const auto offer = [&](std::uint32_t flat, std::uint32_t other, std::size_t e) {
    if (normals[flat] != glm::vec3{0, 0, 0}) return;
    const Edge& edge = topology.edges[e];
    const double length = glm::distance(scene.vertices[edge.v0], scene.vertices[edge.v1]);
    Neighbour& best = neighbours[flat];
    if (length > best.length) best = {length, other, (topology.edge_flags[e] & kEdgeUnlikeWound) != 0};
  };
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    if (edge.face1 == kNone) continue;
    offer(edge.face0, edge.face1, e);
    offer(edge.face1, edge.face0, e);
  }
  std::vector<std::pair<std::uint32_t, glm::vec3>> taken;
  for (const auto& [flat, first] : neighbours) {
    bool turned = false;
    Neighbour next = first;
    for (int k = 0; k < kLongestChain; ++k) {
      turned ^= next.turned;
      if (normals[next.face] != glm::vec3{0, 0, 0}) {
        taken.emplace_back(flat, turned ? -normals[next.face] : normals[next.face]);
        break;
      }
      const auto further = neighbours.find(next.face);
      if (further == neighbours.end()) break;
      next = further->second;
    }
  }
  for (const auto& [flat, normal] : taken) normals[flat] = normal;
}

}  // namespace

std::vector<glm::vec3> face_normals(const Scene& scene, const Topology& topology) {
  std::vector<glm::vec3> normals(scene.faces.size());
  std::atomic<bool> any_without{false};
  for (const Object& object : scene.objects) {
    const std::size_t count = object.face_end - object.face_begin;
    parallel_blocks(count, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
      bool without = false;
      for (std::size_t k = begin; k < end; ++k) {
        const auto f = static_cast<std::uint32_t>(object.face_begin + k);
        normals[f] = own_normal(scene, object, f);
        without = without || normals[f] == glm::vec3{0, 0, 0};
      }
      if (without) any_without.store(true, std::memory_order_relaxed);
    });
  }
  if (any_without) take_from_neighbours(scene, topology, normals);
  return normals;
}

}  // namespace ligne
