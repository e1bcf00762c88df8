#include "scene/heal/merge_ends.hpp"

#include "base/disjoint_sets.hpp"
#include "scene/clean/clean.hpp"

namespace ligne {

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
