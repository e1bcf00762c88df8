#include "view/spatial_order.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "base/prefetch.hpp"

namespace ligne {
namespace {

constexpr int kMortonBits = 10;  ///< per coordinate: a million squares over the page

std::uint32_t spread_bits(std::uint32_t v) {
  v = (v | (v << 8)) & 0x00ff00ffu;
  v = (v | (v << 4)) & 0x0f0f0f0fu;
  v = (v | (v << 2)) & 0x33333333u;
  return (v | (v << 1)) & 0x55555555u;
}

/// The stable order of items by their keys, all below key_count: order[k] is the k-th item. Each task owns a range of
/// keys and reads all items.
std::vector<std::uint32_t> stable_order(const std::vector<std::uint32_t>& keys, std::size_t key_count) {
  const std::size_t n = keys.size();
  // A few items are sorted faster than the keys are counted.
  constexpr std::size_t kKeysPerItem = 16;  // adjustable
  if (n * kKeysPerItem < key_count) {
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(keys[a], a) < std::pair(keys[b], b); });
    return order;
  }
  constexpr std::size_t kItemsPerRange = 200'000, kMostRanges = 4;
  const std::size_t ranges = std::clamp<std::size_t>(n / kItemsPerRange, 1, std::min(kMostRanges, thread_count()));
  std::vector<std::uint32_t> next = large_vector<std::uint32_t>(key_count + 1), order = large_vector<std::uint32_t>(n);
  const auto for_ranges = [&](auto visit) {
    parallel_for(ranges, [&](std::size_t r) {
      const std::size_t first = key_count * r / ranges, count = key_count * (r + 1) / ranges - first;
      for (std::size_t i = 0; i < n; ++i) {
        if (i + kTurnsAhead < n) __builtin_prefetch(next.data() + keys[i + kTurnsAhead]);
        const std::size_t k = keys[i];
        if (k - first < count) visit(k, static_cast<std::uint32_t>(i));
      }
    });
  };
  for_ranges([&](std::size_t k, std::uint32_t) { ++next[k + 1]; });
  for (std::size_t k = 0; k < key_count; ++k) next[k + 1] += next[k];
  for_ranges([&](std::size_t k, std::uint32_t i) { order[next[k]++] = i; });
  return order;
}

template <class T>
std::vector<T> in_order(const std::vector<T>& items, const std::vector<std::uint32_t>& order) {
  std::vector<T> sorted = large_vector<T>(items.size());
  parallel_blocks(items.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kTurnsAhead < end) __builtin_prefetch(items.data() + order[i + kTurnsAhead]);
      sorted[i] = items[order[i]];
    }
  });
  return sorted;
}

}  // namespace

std::uint32_t page_square(LatticePoint p) {
  const auto square = [](std::int32_t v) {
    const auto shifted = static_cast<std::uint32_t>(v + kLatticeLimit);  // 0 .. 2^26
    return std::min(shifted >> (26 - kMortonBits), (1u << kMortonBits) - 1);
  };
  return spread_bits(square(p.x)) | (spread_bits(square(p.y)) << 1);
}

std::vector<std::uint32_t> order_faces_spatially(ProjectedScene& scene) {
  const std::size_t n = scene.vertices.size();
  std::vector<std::uint32_t> number(n);
  parallel_each(n, [&](std::size_t i) { number[i] = page_square(scene.vertices[i].p); });
  const auto order = stable_order(number, std::size_t{1} << (2 * kMortonBits));
  scene.vertices = in_order(scene.vertices, order);
  parallel_each(n, [&](std::size_t k) { number[order[k]] = static_cast<std::uint32_t>(k); });
  std::vector<std::uint32_t> keys = large_vector<std::uint32_t>(scene.triangles.size());
  parallel_each(scene.triangles.size(), [&](std::size_t i) {
    if (i + kTurnsAhead < scene.triangles.size()) prefetch(number, scene.triangles[i + kTurnsAhead].v);
    auto& v = scene.triangles[i].v;
    for (std::uint32_t& corner : v) corner = number[corner];
    keys[i] = std::min({v[0], v[1], v[2]});
  });
  scene.triangles = in_order(scene.triangles, stable_order(keys, n));
  return number;
}

void order_edges_spatially(ProjectedScene& scene, const std::vector<std::uint32_t>& number) {
  std::vector<std::uint32_t> keys = large_vector<std::uint32_t>(scene.edges.size());
  parallel_each(scene.edges.size(), [&](std::size_t i) {
    ProjectedEdge& edge = scene.edges[i];
    edge.v0 = number[edge.v0];
    edge.v1 = number[edge.v1];
    keys[i] = std::min(edge.v0, edge.v1);
  });
  const auto order = stable_order(keys, number.size());
  scene.edges = in_order(scene.edges, order);
  if (!scene.edge_parts.empty()) scene.edge_parts = in_order(scene.edge_parts, order);
}

}  // namespace ligne
