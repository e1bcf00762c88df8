#pragma once
/// Objects by their vertices, and their sizes.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <vector>

#include "base/parallel.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Index of the object that owns a vertex.
inline std::size_t object_of_vertex(const Scene& scene, std::uint32_t vertex) {
  const auto after = std::ranges::upper_bound(scene.objects, vertex, {}, &Object::vertex_end);
  return static_cast<std::size_t>(after - scene.objects.begin());
}

/// Diagonal of the bounding box of an object, 0 if it has no vertices.
inline double object_size(const Scene& scene, const Object& object) {
  if (object.vertex_begin == object.vertex_end) return 0;
  const auto [low, high] = bounds_of(scene, object.vertex_begin, object.vertex_end);
  return glm::distance(low, high);
}

/// object_size() of each object.
inline std::vector<double> object_sizes(const Scene& scene) {
  std::vector<double> sizes(scene.objects.size());
  parallel_for(sizes.size(), [&](std::size_t i) { sizes[i] = object_size(scene, scene.objects[i]); });
  return sizes;
}

}  // namespace ligne
