#include "scene/heal/merge_ends.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "scene/clean/clean.hpp"

namespace ligne {

bool are_within(double distance, const Point3& p, const Point3& q) {
  // Nearly all edges are long in each direction.
  if (!(std::abs(p.x - q.x) < distance)) return false;
  const Point3 way = p - q;
  return glm::dot(way, way) < distance * distance;
}

std::size_t merge_ends(Scene& scene, std::span<const std::array<std::uint32_t, 2>> edges,
                       std::span<const double> distances) {
  if (edges.empty()) return 0;
  DisjointSets chains(scene.vertices.size());
  for (const auto& [first, second] : edges) chains.join(first, second);
  std::size_t merged = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
      const std::uint32_t to = chains.find(v);
      if (to == v || !are_within(distances[i], scene.vertices[to], scene.vertices[v])) continue;
      scene.vertices[v] = scene.vertices[to];
      ++merged;
    }
  }
  Warnings vanished;  // faces without thickness are no loss
  finish_scene(scene, vanished);
  return merged;
}

}  // namespace ligne
