// weld_vertices(): vertices are sorted stably into parts by the top bits of a hash of their position. Every part then has
// its own small hash table with open addressing that fits the cache, and parts are independent of each other. Within a part
// vertices come in ascending order, so the first one at a position stands for the others, at any number of threads.
//
// weld_near_vertices(): the vertices that stay are kept in a hashed grid (near_cells.hpp). Since they are farther apart than
// the distance, a cell holds only a few of them.

#include "scene/clean/weld.hpp"

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

#include "base/hash.hpp"
#include "base/large_vector.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_counting_sort.hpp"
#include "base/parallel_each.hpp"
#include "base/uninitialized_vector.hpp"
#include "scene/clean/near_cells.hpp"

namespace ligne {
namespace {

constexpr unsigned kPartBits = 7;
constexpr std::size_t kParts = std::size_t{1} << kPartBits;
/// Number of entries by which memory is prefetched: the vertices of a part lie all over the scene.
constexpr std::size_t kAhead = 16;
/// Number of vertices that one task hashes and sorts into parts.
constexpr std::size_t kBlock = std::size_t{1} << 15;

std::uint32_t hash(const Point3& p) {
  // Odd multipliers keep the coordinates apart before one finalizer takes them all.
  const std::uint64_t sum = bits_of_number(p.x) * kGoldenRatio + std::rotl(bits_of_number(p.y) * 0xc2b2ae3d27d4eb4fu, 21) +
                            std::rotl(bits_of_number(p.z) * 0x165667b19e3779f9u, 42);
  return static_cast<std::uint32_t>(mix_bits(sum) >> 32);
}

bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

struct Entry {
  std::uint32_t hash;
  std::uint32_t vertex;
};

/// The vertices with finite positions, sorted by part, ascending inside a part.
struct Parts {
  UninitializedVector<Entry> entries;
  std::vector<std::size_t> begin;  ///< first entry of each part, and the end
};

Parts sort_into_parts(const std::vector<Point3>& vertices, std::vector<std::uint32_t>& first) {
  const std::size_t n = vertices.size();
  UninitializedVector<std::uint32_t> hashes(n);
  parallel_each(
      n,
      [&](std::size_t i) {
        first[i] = is_finite(vertices[i]) ? static_cast<std::uint32_t>(i) : kNone;
        hashes[i] = hash(vertices[i]);
      },
      kBlock);
  Parts parts;
  const auto list = [&](std::size_t begin, std::size_t end, const auto& take) {
    for (std::size_t i = begin; i < end; ++i) {
      if (first[i] != kNone) take(hashes[i] >> (32 - kPartBits), Entry{hashes[i], static_cast<std::uint32_t>(i)});
    }
  };
  parts.begin = parallel_counting_sort(
      n, kBlock, kParts, list, [&](std::size_t count) { parts.entries = UninitializedVector<Entry>(count); },
      [&](std::size_t place, const Entry& entry) { parts.entries[place] = entry; });
  return parts;
}

/// Welds the vertices of one part; returns how many were replaced by an earlier one.
std::size_t weld_part(const Scene& scene, std::span<const Entry> entries, std::vector<std::uint32_t>& first) {
  constexpr Entry kFree{0, kNone};
  const std::size_t size = std::bit_ceil(2 * entries.size() + 1);
  const std::size_t mask = size - 1;
  std::vector<Entry> table(size, kFree);
  std::size_t repeated = 0, object = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& e = entries[i];
    if (i + kAhead < entries.size()) {
      __builtin_prefetch(&scene.vertices[entries[i + kAhead].vertex]);
      __builtin_prefetch(&table[entries[i + kAhead].hash & mask]);
    }
    while (e.vertex >= scene.objects[object].vertex_end) ++object;
    const std::uint32_t object_begin = scene.objects[object].vertex_begin;
    for (std::size_t slot = e.hash & mask;; slot = (slot + 1) & mask) {
      Entry& there = table[slot];
      if (there.vertex == kNone) {
        there = e;
        break;
      }
      if (there.hash != e.hash || scene.vertices[there.vertex] != scene.vertices[e.vertex]) continue;
      if (there.vertex < object_begin) {
        there = e;  // this position of an earlier object is not needed any more
      } else {
        first[e.vertex] = there.vertex;
        ++repeated;
      }
      break;
    }
  }
  return repeated;
}

class NearVertices {
 public:
  /// `count`: largest number of vertices that will be added.
  NearVertices(std::vector<Point3>& vertices, double distance, std::size_t count)
      : vertices_(vertices), distance_(distance), heads_(std::bit_ceil(count + 1), kNone) {}

  /// Moves vertex v onto one that stays, or adds it to those.
  void take(std::uint32_t v) {
    const Point3 p = vertices_[v];
    const NearCells cells(p, distance_);
    if (!cells.finite()) return;
    const auto slots = cells.slots(heads_.size());
    for (const std::size_t slot : slots) {
      std::uint32_t link = heads_[slot];
      for (; link != kNone; link = links_[link].next) {
        const Point3 there = links_[link].position;
        if (glm::distance(there, p) > distance_) continue;
        vertices_[v] = there;
        return;
      }
    }
    std::uint32_t& head = heads_[slots[0]];
    links_.push_back({p, head});
    head = static_cast<std::uint32_t>(links_.size() - 1);
  }

 private:
  struct Link {
    Point3 position;  ///< of a vertex that stays
    std::uint32_t next;
  };

  std::vector<Point3>& vertices_;
  double distance_;
  std::vector<std::uint32_t> heads_;  ///< per slot: the first link of the vertices in its cells
  std::vector<Link> links_;
};

}  // namespace

Weld weld_vertices(const Scene& scene) {
  Weld weld;
  weld.first = large_vector<std::uint32_t>(scene.vertices.size());
  const Parts parts = sort_into_parts(scene.vertices, weld.first);
  weld.not_finite = scene.vertices.size() - parts.begin.back();
  std::vector<std::size_t> repeated(kParts, 0);
  parallel_for(kParts, [&](std::size_t p) {
    const std::span<const Entry> entries(parts.entries.data() + parts.begin[p], parts.entries.data() + parts.begin[p + 1]);
    repeated[p] = weld_part(scene, entries, weld.first);
  });
  weld.repeated = std::accumulate(repeated.begin(), repeated.end(), std::size_t{0});
  return weld;
}

void weld_near_vertices(Scene& scene, double distance) {
  const auto weld = [&](std::uint32_t begin, std::uint32_t end) {
    NearVertices near(scene.vertices, distance, end - begin);
    for (std::uint32_t v = begin; v < end; ++v) near.take(v);
  };
  if (scene.objects.empty()) {
    weld(0, static_cast<std::uint32_t>(scene.vertices.size()));
    return;
  }
  parallel_for(scene.objects.size(),
               [&](std::size_t i) { weld(scene.objects[i].vertex_begin, scene.objects[i].vertex_end); });
}

}  // namespace ligne
