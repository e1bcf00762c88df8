#include "scene/clean/compact.hpp"

#include <atomic>

#include "geometry/parallel.hpp"

namespace ligne {
namespace {

/// Corners that one task visits.

template <class Work>
void for_blocks(std::size_t n, const Work& work) {
  parallel_blocks(n, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) work(i);
  });
}

}  // namespace

void drop_unused_vertices(Scene& scene) {
  const std::span<std::uint32_t> corners = scene.faces.corners();
  const std::size_t n = scene.vertices.size();
  // Several threads may mark one vertex; all of them write the same.
  std::vector<std::uint8_t> used(n, 0);
  for_blocks(corners.size(), [&](std::size_t k) {
    std::atomic_ref<std::uint8_t> mark(used[corners[k]]);
    if (!mark.load(std::memory_order_relaxed)) mark.store(1, std::memory_order_relaxed);
  });
  std::vector<std::uint32_t> new_index(n + 1);
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < n; ++v) {
    new_index[v] = count;
    count += used[v];
  }
  new_index[n] = count;
  if (count == n) return;
  for (std::size_t v = 0; v < n; ++v) {
    if (used[v]) scene.vertices[new_index[v]] = scene.vertices[v];
  }
  scene.vertices.resize(count);
  for_blocks(corners.size(), [&](std::size_t k) { corners[k] = new_index[corners[k]]; });
  for (Object& object : scene.objects) {
    object.vertex_begin = new_index[object.vertex_begin];
    object.vertex_end = new_index[object.vertex_end];
  }
}

void renumber_faces(Scene& scene, const std::vector<std::uint32_t>& first_new, Warnings& warnings) {
  for (Object& object : scene.objects) {
    object.face_begin = first_new[object.face_begin];
    object.face_end = first_new[object.face_end];
  }
  const std::size_t dropped = std::erase_if(scene.details, [&](Detail& detail) {
    const bool gone = first_new[detail.face] == first_new[detail.face + 1];
    detail.face = first_new[detail.face];
    return gone;
  });
  warnings.add("details of dropped faces dropped", dropped);
}

}  // namespace ligne
