#include "picture/stream/streamed_vertices.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/portable.hpp"
#include "picture/stream/stream_passes.hpp"
#include "picture/stream/streamed_clusters.hpp"

namespace ligne {
namespace {

/// A hash table that numbers positions in space.
class PlaceTable {
 public:
  std::uint32_t add(const Point3& p) {
    if (2 * places_.size() + 2 > slots_.size()) grow();
    const std::uint64_t number = place_number(p);
    std::uint32_t& slot = slots_[find_slot(p, number)];
    if (slot == kNone) {
      slot = static_cast<std::uint32_t>(places_.size());
      filter_[word(number)] |= bit(number);
      places_.push_back(p);
    }
    return slot;
  }
  /// Returns kNone for a position that is not in the table.
  std::uint32_t find(const Point3& p) const {
    const std::uint64_t number = place_number(p);
    return filter_[word(number)] & bit(number) ? slots_[find_slot(p, number)] : kNone;
  }
  const std::vector<Point3>& places() const { return places_; }
  std::vector<Point3> take_places() { return std::move(places_); }

 private:
  static constexpr std::size_t kFewest = 1024;
  /// Slots for each word of the filter, which has eight bits for each slot. Most searched positions are not in the
  /// table, and the small filter finds this for nearly all of them.
  static constexpr std::size_t kSlotsPerWord = 8;

  std::size_t word(std::uint64_t number) const { return number >> 38 & (filter_.size() - 1); }
  static std::uint64_t bit(std::uint64_t number) { return std::uint64_t{1} << (number >> 32 & 63); }
  std::size_t find_slot(const Point3& p, std::uint64_t number) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = number & mask;
    while (slots_[slot] != kNone && places_[slots_[slot]] != p) slot = (slot + 1) & mask;
    return slot;
  }
  void grow() {
    slots_.assign(std::max(kFewest, 2 * slots_.size()), kNone);
    filter_.assign(slots_.size() / kSlotsPerWord, 0);
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      const std::uint64_t number = place_number(places_[i]);
      slots_[find_slot(places_[i], number)] = i;
      filter_[word(number)] |= bit(number);
    }
  }

  std::vector<std::uint32_t> slots_;
  std::vector<std::uint64_t> filter_;
  std::vector<Point3> places_;
};

/// Returns the corners of the triangles as numbers of positions, which are numbered in order of appearance.
std::vector<std::uint32_t> take_corners(const TriangleFile& file, std::span<const std::uint32_t> triangles,
                                        PlaceTable& places) {
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * triangles.size());
  std::size_t block = 0;
  for (const std::uint32_t t : triangles) {
    if (t >= block + kStreamedBlock) {
      file.forget_triangles(block, t);
      block = t;
    }
    std::array<Point3, 3> p;
    file.read_triangles(t, t + std::size_t{1}, p.data());
    for (const Point3& corner : p) corners.push_back(places.add(corner));
  }
  return corners;
}

/// Returns the first vertex of the file at each position, and counts all vertices in `clusters`.
std::vector<std::uint32_t> first_vertices(const TriangleFile& file, const PlaceTable& table, std::size_t places,
                                          ClusterCounter& clusters) {
  std::vector<std::uint32_t> first(places, kNone);
  parallel_blocks(file.vertex_count(), 3 * kStreamedBlock, [&](std::size_t begin, std::size_t end) {
    thread_local std::vector<Point3> positions;
    positions.resize(end - begin);
    file.read_vertices(begin, end, positions.data());
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t place = table.find(positions[i - begin]);
      clusters.count(positions[i - begin], place != kNone);
      if (place == kNone) continue;
      AtomicRef<std::uint32_t> lowest(first[place]);
      std::uint32_t known = lowest.load(std::memory_order_relaxed);
      while (i < known && !lowest.compare_exchange_weak(known, static_cast<std::uint32_t>(i), std::memory_order_relaxed)) {
      }
    }
    file.forget_vertices(begin, end);
  });
  return first;
}

/// Returns the given triangles, and those with a corner in a cluster that would be split.
std::vector<std::uint32_t> with_split_clusters(const TriangleFile& file, const std::vector<std::uint32_t>& triangles,
                                               const ClusterCounter& clusters) {
  return find_triangles(file, [&](std::size_t t, const Point3* corners) {
    return std::ranges::binary_search(triangles, static_cast<std::uint32_t>(t)) ||
           (!is_degenerate(corners) &&
            std::any_of(corners, corners + 3, [&](const Point3& corner) { return clusters.is_split(corner); }));
  });
}

/// The positions that triangles need, and the corners of the triangles as numbers of positions.
struct NeededVertices {
  std::vector<Point3> places;  ///< in any order
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first;  ///< by position: its first vertex in the file
};

/// Adds triangles until no cluster is split.
NeededVertices find_vertices(const TriangleFile& file, const StreamFacets& facets, std::vector<std::uint32_t>& triangles) {
  for (;;) {
    NeededVertices needed;
    PlaceTable table;
    needed.corners = take_corners(file, triangles, table);
    ClusterCounter clusters(facets, table.places());
    needed.first = first_vertices(file, table, table.places().size(), clusters);
    needed.places = table.take_places();
    const std::size_t before = triangles.size();
    if (clusters.any_split()) triangles = with_split_clusters(file, triangles, clusters);
    if (triangles.size() == before) return needed;
  }
}

}  // namespace

Scene scene_of_needed(const TriangleFile& file, const StreamFacets& facets, std::vector<std::uint32_t> triangles) {
  const NeededVertices needed = find_vertices(file, facets, triangles);
  std::vector<std::uint32_t> order(needed.first.size()), number(order.size());
  std::iota(order.begin(), order.end(), 0u);
  parallel_sort(order.begin(), order.end(),
                [&](std::uint32_t a, std::uint32_t b) { return needed.first[a] < needed.first[b]; });
  Scene scene;
  scene.vertices.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[order[i]] = static_cast<std::uint32_t>(i);
    scene.vertices[i] = needed.places[order[i]];
  }
  const std::span<std::uint32_t> corners = scene.faces.append_triangles(triangles.size());
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = number[needed.corners[i]];
  Object object;
  object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  object.face_end = static_cast<std::uint32_t>(triangles.size());
  object.precision = file.precision();
  scene.objects.push_back(object);
  return scene;
}

}  // namespace ligne
