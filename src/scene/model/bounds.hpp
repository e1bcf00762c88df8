#pragma once
/// Bounding boxes of the vertices of a scene.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "base/parallel.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

struct Bounds {
  Point3 low{0, 0, 0}, high{0, 0, 0};
};

/// Bounding box of the vertices [begin, end). The range must not be empty.
inline Bounds bounds_of(const Scene& scene, std::size_t begin, std::size_t end) {
  const auto of_block = [&](std::size_t first, std::size_t last) {
    Point3 low = scene.vertices[begin + first], high = low;
    for (std::size_t v = begin + first; v < begin + last; ++v) {
      const Point3 p = scene.vertices[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return Bounds{low, high};
  };
  const auto together = [](const Bounds& a, const Bounds& b) {
    return Bounds{glm::min(a.low, b.low), glm::max(a.high, b.high)};
  };
  const Bounds start{scene.vertices[begin], scene.vertices[begin]};
  return parallel_reduce(end - begin, kShortWorkBlock, start, of_block, together);
}

/// The centre of the scene's bounding box; the origin if there are no vertices.
inline Point3 bounding_box_centre(const Scene& scene) {
  if (scene.vertices.empty()) return {0, 0, 0};
  const auto [low, high] = bounds_of(scene, 0, scene.vertices.size());
  return low + (high - low) * 0.5;
}

/// Largest absolute value of a coordinate; 0 without vertices.
inline double largest_coordinate(const Scene& scene) {
  if (scene.vertices.empty()) return 0;
  const auto [low, high] = bounds_of(scene, 0, scene.vertices.size());
  const Point3 sizes = glm::max(glm::abs(low), glm::abs(high));
  return std::max({sizes.x, sizes.y, sizes.z});
}

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
