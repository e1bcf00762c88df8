#include "scene/heal/merge_ends.hpp"

#include <algorithm>

#include "base/disjoint_sets.hpp"
#include "base/indices_where.hpp"
#include "base/prefetch.hpp"
#include "scene/clean/clean.hpp"

namespace ligne {

std::vector<std::uint32_t> narrow_faces(const Scene& scene, const Object& object, double distance) {
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  const bool all_triangles = scene.faces.all_triangles();
  const auto is_narrow = [&, corner = corners.data(), at = scene.vertices.data()](std::size_t f) {
    const Point3 &a = at[corner[3 * f]], &b = at[corner[3 * f + 1]], &c = at[corner[3 * f + 2]];
    // Most edges are long in the direction of x.
    const double least = std::min(std::min(std::abs(a.x - b.x), std::abs(b.x - c.x)), std::abs(c.x - a.x));
    return least < distance && (are_within(distance, a, b) || are_within(distance, b, c) || are_within(distance, c, a));
  };
  std::vector<std::uint32_t> faces = indices_where(object.face_end - object.face_begin, [&](std::size_t i) {
    const std::size_t f = object.face_begin + i;
    if (!all_triangles) return true;
    prefetch_corners(scene.vertices, corners, f);
    return is_narrow(f);
  });
  for (std::uint32_t& f : faces) f += object.face_begin;
  return faces;
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
