#include "picture/stream/streamed_vertices.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/portable.hpp"
#include "picture/stream/stream_passes.hpp"
#include "view/tolerances.hpp"
#include "view/vertex_clusters.hpp"

namespace ligne {
namespace {

/// Finds clusters of vertices (view/vertex_clusters.hpp) of which only a part would be kept.

/// Cubes of page space around the needed vertices, larger than the cubes of clusters. If such a cube contains enough
/// vertices for a cluster, and not all of them are needed, the kept vertices would be merged differently than in the
/// whole model.
class ClusterCounter {
 public:
  /// `places`: positions of the needed vertices.
  ClusterCounter(const StreamFacets& facets, std::span<const Point3> places);

  /// Counts a vertex. To be called for all vertices of the file; several threads may call it.
  void count(const Point3& vertex, bool needed);
  /// Whether a vertex of the file lies in a cluster that would be split. Call it after all vertices are counted.
  bool is_split(const Point3& vertex) const;
  bool any_split() const;

 private:
  struct Cube {
    std::uint64_t number = 0;  ///< 0: no cube
    std::atomic<std::uint32_t> vertices{0}, not_needed{0};
    bool torn() const;
  };

  std::size_t slot_of(std::uint64_t number) const;
  std::uint64_t number_of(const Point3& vertex) const;

  const StreamFacets& facets_;
  double side_mm_, reach_mm_;
  std::vector<Cube> cubes_;
};

/// Reach of the vertices of a cluster, in coincidences and lattice steps. Two cubes may compete for vertices only if
/// all their vertices are within three sides of a cluster's cube, which are one and a half coincidences, apart from
/// rounding.
constexpr double kReachInCoincidences = 1.5, kReachSteps = 4;
/// Adjustable: larger cubes are fewer, but contain more vertices that belong to no cluster.
constexpr double kSideInReaches = 8;

std::uint64_t cube_number(const std::array<double, 3>& cube) {
  return place_number({cube[0], cube[1], cube[2]}) | 1;  // 0 stands for no cube
}

ClusterCounter::ClusterCounter(const StreamFacets& facets, std::span<const Point3> places) : facets_(facets) {
  const ProjectedScene& page = facets.page();
  reach_mm_ = kReachInCoincidences * coincidence_mm(page) + kReachSteps * page.lattice.step_mm;
  side_mm_ = kSideInReaches * reach_mm_;
  std::vector<std::uint64_t> numbers;
  for (const Point3& place : places) {
    const std::array<double, 3> p = facets.page_place(place);
    // A vertex near the sides of its cube may belong to a cluster in the next cube too.
    for (int k = 0; k < 8; ++k) {
      std::array<double, 3> cube;
      bool repeated = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = std::floor((p[axis] - reach_mm_) / side_mm_), high = std::floor((p[axis] + reach_mm_) / side_mm_);
        const bool upper = k >> axis & 1;
        repeated = repeated || (upper && low == high);
        cube[axis] = upper ? high : low;
      }
      if (!repeated) numbers.push_back(cube_number(cube));
    }
  }
  cubes_ = std::vector<Cube>(std::bit_ceil(2 * numbers.size() + 1));
  for (const std::uint64_t number : numbers) cubes_[slot_of(number)].number = number;
}

std::size_t ClusterCounter::slot_of(std::uint64_t number) const {
  const std::size_t mask = cubes_.size() - 1;
  std::size_t slot = number >> 1 & mask;
  while (cubes_[slot].number != 0 && cubes_[slot].number != number) slot = (slot + 1) & mask;
  return slot;
}

std::uint64_t ClusterCounter::number_of(const Point3& vertex) const {
  std::array<double, 3> cube = facets_.page_place(vertex);
  for (double& c : cube) c = std::floor(c / side_mm_);
  return cube_number(cube);
}

void ClusterCounter::count(const Point3& vertex, bool needed) {
  Cube& cube = cubes_[slot_of(number_of(vertex))];
  if (cube.number == 0) return;
  cube.vertices.fetch_add(1, std::memory_order_relaxed);
  if (!needed) cube.not_needed.fetch_add(1, std::memory_order_relaxed);
}

bool ClusterCounter::Cube::torn() const { return vertices > kMaxVerticesPerCube && not_needed > 0; }

bool ClusterCounter::is_split(const Point3& vertex) const { return cubes_[slot_of(number_of(vertex))].torn(); }

bool ClusterCounter::any_split() const {
  return std::any_of(cubes_.begin(), cubes_.end(), [](const Cube& cube) { return cube.torn(); });
}

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
  scene.objects.push_back({.vertex_end = static_cast<std::uint32_t>(scene.vertices.size()),
                           .face_end = static_cast<std::uint32_t>(triangles.size()),
                           .precision = file.precision()});
  return scene;
}

}  // namespace ligne
