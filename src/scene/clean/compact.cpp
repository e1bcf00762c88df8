#include "scene/clean/compact.hpp"

#include <atomic>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "base/portable.hpp"

namespace ligne {
namespace {

template <class Work>
void for_blocks(std::size_t n, const Work& work) {
  parallel_blocks(n, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) work(i);
  });
}

/// Moves the vertices for which stays(v) holds to the front, and adapts the ranges of the objects. `number` has one
/// entry more than there are vertices: the new index of each vertex, or of the next one that stays.
template <class IsKept>
void keep_vertices(Scene& scene, const std::vector<std::uint32_t>& number, const IsKept& stays) {
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    if (stays(v)) scene.vertices[number[v]] = scene.vertices[v];
  }
  scene.vertices.resize(number.back());
  for (Object& object : scene.objects) {
    object.vertex_begin = number[object.vertex_begin];
    object.vertex_end = number[object.vertex_end];
  }
}

}  // namespace

void drop_unused_vertices(Scene& scene) {
  const std::span<std::uint32_t> corners = scene.faces.corners();
  const std::size_t n = scene.vertices.size();
  // Several threads may mark one vertex; all write the same value.
  std::vector<std::uint8_t> used(n, 0);
  for_blocks(corners.size(), [&](std::size_t k) {
    AtomicRef<std::uint8_t> mark(used[corners[k]]);
    if (!mark.load(std::memory_order_relaxed)) mark.store(1, std::memory_order_relaxed);
  });
  std::vector<std::uint32_t> new_index = large_vector<std::uint32_t>(n + 1);
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < n; ++v) {
    new_index[v] = count;
    count += used[v];
  }
  new_index[n] = count;
  if (count == n) return;
  keep_vertices(scene, new_index, [&](std::size_t v) { return used[v] != 0; });
  for_blocks(corners.size(), [&](std::size_t k) { corners[k] = new_index[corners[k]]; });
}

void merge_vertices(Scene& scene, std::vector<std::uint32_t> target) {
  const std::size_t n = scene.vertices.size();
  std::vector<std::uint32_t> number(n + 1);
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < n; ++v) {
    number[v] = count;
    count += target[v] == v;
  }
  number[n] = count;
  keep_vertices(scene, number, [&](std::size_t v) { return target[v] == v; });
  for (std::uint32_t& to : target) to = number[to];
  const std::span<std::uint32_t> corners = scene.faces.corners();
  for_blocks(corners.size(), [&](std::size_t k) { corners[k] = target[corners[k]]; });
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
