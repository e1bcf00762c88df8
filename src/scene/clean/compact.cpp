#include "scene/clean/compact.hpp"

#include <atomic>
#include <numeric>
#include <utility>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "base/portable.hpp"

namespace ligne {
namespace {

/// The new index of each of n vertices, or of the next one that stays; behind these, the number of those that stay.
template <class IsKept>
std::vector<std::uint32_t> new_numbers(std::size_t n, const IsKept& stays) {
  std::vector<std::uint32_t> first(block_count(n, kShortWorkBlock) + 1, 0);  // per block
  parallel_blocks(n, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    std::uint32_t count = 0;
    for (std::size_t v = begin; v < end; ++v) count += stays(v);
    first[begin / kShortWorkBlock + 1] = count;
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> number = large_vector<std::uint32_t>(n + 1);
  parallel_blocks(n, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    std::uint32_t next = first[begin / kShortWorkBlock];
    for (std::size_t v = begin; v < end; ++v) {
      number[v] = next;
      next += stays(v);
    }
  });
  number[n] = first.back();
  return number;
}

/// Keeps the vertices for which stays(v) holds, and adapts the ranges of the objects. `number`: their new_numbers().
template <class IsKept>
void keep_vertices(Scene& scene, const std::vector<std::uint32_t>& number, const IsKept& stays) {
  std::vector<Point3> kept = large_vector<Point3>(number.back());
  parallel_each(scene.vertices.size(), [&](std::size_t v) {
    if (stays(v)) kept[number[v]] = scene.vertices[v];
  });
  scene.vertices = std::move(kept);
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
  parallel_each(corners.size(), [&](std::size_t k) {
    AtomicRef<std::uint8_t> mark(used[corners[k]]);
    if (!mark.load(std::memory_order_relaxed)) mark.store(1, std::memory_order_relaxed);
  });
  const auto stays = [&](std::size_t v) { return used[v] != 0; };
  const std::vector<std::uint32_t> new_index = new_numbers(n, stays);
  if (new_index.back() == n) return;
  keep_vertices(scene, new_index, stays);
  parallel_each(corners.size(), [&](std::size_t k) { corners[k] = new_index[corners[k]]; });
}

void merge_vertices(Scene& scene, std::vector<std::uint32_t> target) {
  const auto stays = [&](std::size_t v) { return target[v] == v; };
  const std::vector<std::uint32_t> number = new_numbers(scene.vertices.size(), stays);
  keep_vertices(scene, number, stays);
  for (std::uint32_t& to : target) to = number[to];
  const std::span<std::uint32_t> corners = scene.faces.corners();
  parallel_each(corners.size(), [&](std::size_t k) { corners[k] = target[corners[k]]; });
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
