#include "scene/model/find_edges.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <type_traits>
#include <utility>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "base/parallel_counting_sort.hpp"
#include "base/uninitialized_vector.hpp"

// Edges are found by counting sort. Every corner of a contour gives one half-edge, filed under the lower of its two
// vertices. A bucket holds the half-edges of one vertex (six on average) and is sorted by the other vertex. Half-edges
// first go into parts, each for a range of vertices, whose buckets fit the cache. Blocks of faces write into a part in
// their order. So the order within a bucket is that of the corners, at any number of threads.
//
// Where adjacency is stated, only the half-edges that run from the lower vertex to the higher one are sorted. Each is an
// edge of its own if the fact holds, so its place in the buckets is the number of the edge. A half-edge that runs the other
// way looks for its edge in the bucket of its lower vertex, and enters its face there. The fact holds if as many run either
// way, no two of the first are equal, and no two of the others find one edge.

namespace ligne {
namespace {

/// Number of faces in a block, and of vertices in a part, of the counting sort. Adjustable.
constexpr std::size_t kFacesPerBlock = 16'384, kVerticesPerPart = 4096;

constexpr std::uint32_t kReversed = 0x80000000u;  ///< the half-edge runs from the higher vertex to the lower

struct HalfEdge {
  std::uint32_t other;               ///< the higher vertex
  std::uint32_t face_and_direction;  ///< face, with kReversed where it applies
  std::uint32_t face() const { return face_and_direction & ~kReversed; }
};

struct FlaggedHalfEdge : HalfEdge {
  std::uint8_t corner_flags;
};

/// Half-edges by their lower vertex, in a bucket by the other one, equal ones in the order of the corners.
template <class Entry>
struct Buckets {
  std::vector<std::uint32_t> begin;  ///< first half-edge of each vertex, and the end
  UninitializedVector<Entry> half_edges;
  std::vector<std::size_t> first_edge;  ///< per part: number of edges in the parts before it; then their number

  std::span<Entry> of_vertex(std::size_t v) { return {half_edges.data() + begin[v], half_edges.data() + begin[v + 1]}; }
  std::size_t vertex_count() const { return begin.size() - 1; }
  std::size_t part_count() const { return block_count(vertex_count(), kVerticesPerPart); }
};

/// Calls visit(vertex, half-edges) for every edge of a part: a run of half-edges with equal ends.
template <class Entry, class Visit>
void for_each_edge(Buckets<Entry>& buckets, std::size_t part, const Visit& visit) {
  const std::size_t last = std::min(buckets.vertex_count(), (part + 1) * kVerticesPerPart);
  for (std::size_t v = part * kVerticesPerPart; v < last; ++v) {
    const std::span<Entry> bucket = buckets.of_vertex(v);
    for (std::size_t k = 0; k < bucket.size();) {
      std::size_t end = k + 1;
      while (end < bucket.size() && bucket[end].other == bucket[k].other) ++end;
      visit(static_cast<std::uint32_t>(v), bucket.subspan(k, end - k));
      k = end;
    }
  }
}

/// Calls visit(from, to, face, corner) for every directed edge of every contour of the faces [begin, end).
template <class Visit>
void for_each_half_edge(const PolygonFaces& faces, std::size_t begin, std::size_t end, Visit visit) {
  if (faces.all_triangles()) {
    const auto corners = faces.corners();
    for (std::size_t f = begin, k = 3 * begin; f < end; ++f, k += 3) {
      visit(corners[k], corners[k + 1], f, k);
      visit(corners[k + 1], corners[k + 2], f, k + 1);
      visit(corners[k + 2], corners[k], f, k + 2);
    }
    return;
  }
  for (std::size_t f = begin; f < end; ++f) {
    for (std::size_t c = 0; c < faces.contour_count(f); ++c) {
      const auto contour = faces.contour(f, c);
      const std::size_t first = faces.corner_index(f, c);
      for (std::size_t k = 0; k < contour.size(); ++k) {
        visit(contour[k], contour[k + 1 == contour.size() ? 0 : k + 1], f, first + k);
      }
    }
  }
}

/// Sorts a bucket by the other vertex. The sort is stable.
template <class Entry>
void sort_bucket(std::span<Entry> bucket) {
  constexpr std::size_t kInsertionSortLimit = 32;
  if (bucket.size() > kInsertionSortLimit) {  // the hub of a large fan
    std::ranges::stable_sort(bucket, {}, &Entry::other);
    return;
  }
  for (std::size_t i = 1; i < bucket.size(); ++i) {
    const Entry moved = bucket[i];
    std::size_t k = i;
    for (; k > 0 && moved.other < bucket[k - 1].other; --k) bucket[k] = bucket[k - 1];
    if (k < i) bucket[k] = moved;
  }
}

/// The half-edges of a part: those of a range of vertices.
template <class Entry>
struct PartEntry {
  std::uint32_t lower;
  Entry half_edge;
};

/// Files the half-edges of a part, whose vertices are [first, last), from `first_place` on. The caller has written where the
/// part begins and ends, since other tasks read that.
template <class Entry>
void fill_buckets(std::span<const PartEntry<Entry>> entries, std::size_t first_place, std::size_t first, std::size_t last,
                  Buckets<Entry>& buckets) {
  // Counts first, then the positions of the next half-edges.
  std::vector<std::uint32_t> next(last - first, 0);
  for (const PartEntry<Entry>& entry : entries) ++next[entry.lower - first];
  auto sum = static_cast<std::uint32_t>(first_place);
  for (std::size_t v = first; v < last; ++v) {
    sum += std::exchange(next[v - first], sum);
    if (v + 1 < last) buckets.begin[v + 1] = sum;
  }
  for (const PartEntry<Entry>& entry : entries) buckets.half_edges[next[entry.lower - first]++] = entry.half_edge;
  for (std::size_t v = first; v < last; ++v) sort_bucket(buckets.of_vertex(v));
}

/// Sorts the half-edges that takes(from, to) chooses.
template <class Entry, class Takes>
Buckets<Entry> sort_half_edges(const Scene& scene, const Takes& takes) {
  UninitializedVector<PartEntry<Entry>> entries;
  const auto list = [&](std::size_t begin, std::size_t end, const auto& take) {
    for_each_half_edge(scene.faces, begin, end, [&](std::uint32_t a, std::uint32_t b, std::size_t face, std::size_t corner) {
      if (takes(a, b)) take(std::min(a, b) / kVerticesPerPart, a, b, face, corner);
    });
  };
  const auto allocate = [&](std::size_t n) { entries = UninitializedVector<PartEntry<Entry>>(n); };
  const auto put = [&](std::size_t place, std::uint32_t a, std::uint32_t b, std::size_t face, std::size_t corner) {
    const auto [lower, higher] = std::minmax(a, b);
    PartEntry<Entry>& entry = entries[place];
    entry.lower = lower;
    entry.half_edge.other = higher;
    entry.half_edge.face_and_direction = static_cast<std::uint32_t>(face) | (a > b ? kReversed : 0);
    if constexpr (std::is_same_v<Entry, FlaggedHalfEdge>) entry.half_edge.corner_flags = scene.corner_flags[corner];
  };
  const std::size_t vertices = scene.vertices.size(), parts = block_count(vertices, kVerticesPerPart);
  const std::vector<std::size_t> part_begin =
      parallel_counting_sort(scene.faces.size(), kFacesPerBlock, parts, list, allocate, put);
  Buckets<Entry> buckets;
  buckets.begin = large_vector<std::uint32_t>(vertices + 1);
  for (std::size_t part = 0; part <= parts; ++part) {
    buckets.begin[std::min(vertices, part * kVerticesPerPart)] = static_cast<std::uint32_t>(part_begin[part]);
  }
  buckets.half_edges = UninitializedVector<Entry>(part_begin[parts]);
  buckets.first_edge.assign(parts + 1, 0);
  parallel_for(parts, [&](std::size_t part) {
    const std::size_t first = part * kVerticesPerPart, last = std::min(vertices, first + kVerticesPerPart);
    const std::span<const PartEntry<Entry>> of_part(entries.data() + part_begin[part],
                                                    entries.data() + part_begin[part + 1]);
    fill_buckets(of_part, part_begin[part], first, last, buckets);
    for_each_edge(buckets, part, [&](std::uint32_t, std::span<Entry>) { ++buckets.first_edge[part + 1]; });
  });
  for (std::size_t part = 0; part < parts; ++part) buckets.first_edge[part + 1] += buckets.first_edge[part];
  return buckets;
}

/// Edge flags by corner flags: those set if any face of the edge has the corner flag, and those set if all have it.
struct EdgeFlags {
  std::array<std::uint16_t, 256> of_any{}, of_all{};
};

constexpr EdgeFlags kEdgeFlags = [] {
  EdgeFlags flags;
  for (unsigned corner = 0; corner < 256; ++corner) {
    const auto take = [&](unsigned if_corner, std::uint16_t edge) -> std::uint16_t { return corner & if_corner ? edge : 0; };
    flags.of_any[corner] = take(kCornerCurve, kEdgeCurve) | take(kCornerCrossing, kEdgeCrossing) |
                           take(kCornerContour, kEdgeContour) | take(kCornerSharp, kEdgeSharp);
    flags.of_all[corner] = take(kCornerFileHidden, kEdgeFileHidden) | take(kCornerInner, kEdgeInner) |
                           take(kCornerSmooth, kEdgeSmooth) | take(kCornerLimit, kEdgeLimit);
  }
  return flags;
}();

template <class Entry>
std::uint16_t flags_of_edge(std::span<const Entry> edge) {
  std::uint16_t flags = 0;
  if (edge.size() > 2) flags |= kEdgeManyFaces;
  if (edge.size() == 1) flags |= kEdgeBorder;
  if (edge.size() == 2) {
    // A seam: the contour of one face runs along it twice.
    if (edge[0].face() == edge[1].face()) return kEdgeInner;
    if ((edge[0].face_and_direction & kReversed) == (edge[1].face_and_direction & kReversed)) flags |= kEdgeUnlikeWound;
  }
  if constexpr (std::is_same_v<Entry, FlaggedHalfEdge>) {
    std::uint8_t common = 0xff, any = 0;  // a flag of the file holds for an edge if all its faces have it
    for (const Entry& half_edge : edge) {
      common &= half_edge.corner_flags;
      any |= half_edge.corner_flags;
    }
    flags |= kEdgeFlags.of_any[any] | kEdgeFlags.of_all[common];
  }
  return flags;
}

template <class Entry>
void find_all_edges(const Scene& scene, Topology& topology) {
  Buckets<Entry> buckets = sort_half_edges<Entry>(scene, [](std::uint32_t, std::uint32_t) { return true; });
  const std::size_t count = buckets.first_edge.back();
  topology.edges = large_vector<Edge>(count);
  topology.edge_flags = large_vector<std::uint16_t>(count);
  topology.first_edges = large_vector<std::uint32_t>(buckets.vertex_count() + 1);
  topology.first_edges[buckets.vertex_count()] = static_cast<std::uint32_t>(count);
  parallel_for(buckets.part_count(), [&](std::size_t part) {
    std::size_t e = buckets.first_edge[part], v = part * kVerticesPerPart;
    for_each_edge(buckets, part, [&](std::uint32_t lower, std::span<const Entry> edge) {
      for (; v <= lower; ++v) topology.first_edges[v] = static_cast<std::uint32_t>(e);
      topology.edges[e] = {lower, edge[0].other, edge[0].face(), edge.size() > 1 ? edge[1].face() : kNone};
      topology.edge_flags[e] = flags_of_edge(edge);
      ++e;
    });
    const std::size_t last = std::min(buckets.vertex_count(), (part + 1) * kVerticesPerPart);
    for (; v < last; ++v) topology.first_edges[v] = static_cast<std::uint32_t>(e);
  });
}

/// Finds the edge to `higher` in the bucket of its lower vertex; kNone if there is none.
std::uint32_t edge_to(std::uint32_t higher, std::uint32_t from, std::uint32_t to,
                      const UninitializedVector<HalfEdge>& half_edges) {
  constexpr std::uint32_t kLinearSearchLimit = 16;
  while (to - from > kLinearSearchLimit) {  // the hub of a large fan
    const std::uint32_t middle = from + (to - from) / 2;
    (half_edges[middle].other <= higher ? from : to) = middle;
  }
  for (; from < to; ++from) {
    if (half_edges[from].other == higher) return from;
  }
  return kNone;
}

using SecondFaces = std::vector<std::atomic<std::uint32_t>>;

/// Enters the second faces of the edges, plus one. False if the half-edges that run downwards are not one for each edge.
bool enter_second_faces(const PolygonFaces& faces, const Buckets<HalfEdge>& forward, SecondFaces& second) {
  std::atomic<std::size_t> pairs = 0;
  parallel_blocks(faces.size(), kFacesPerBlock, [&](std::size_t first, std::size_t last) {
    std::size_t found = 0;
    for_each_half_edge(faces, first, last, [&](std::uint32_t a, std::uint32_t b, std::size_t face, std::size_t) {
      if (a < b) return;
      const std::uint32_t edge = edge_to(a, forward.begin[b], forward.begin[b + 1], forward.half_edges);
      if (edge == kNone) return;
      found += second[edge].exchange(static_cast<std::uint32_t>(face) + 1, std::memory_order_relaxed) == 0;
    });
    pairs += found;
  });
  return pairs == second.size();
}

}  // namespace

bool find_paired_edges(const Scene& scene, Topology& topology) {
  const std::size_t corners = scene.faces.corners().size();
  if (!scene.corner_flags.empty() || corners == 0) return false;
  Buckets<HalfEdge> forward = sort_half_edges<HalfEdge>(scene, [](std::uint32_t a, std::uint32_t b) { return a < b; });
  const std::size_t count = forward.begin.back();
  if (2 * count != corners || forward.first_edge.back() != count) return false;
  SecondFaces second(count);
  if (!enter_second_faces(scene.faces, forward, second)) return false;
  topology.edges = large_vector<Edge>(count);
  topology.edge_flags = large_vector<std::uint16_t>(count);
  parallel_for(forward.part_count(), [&](std::size_t part) {
    std::size_t e = forward.first_edge[part];
    for_each_edge(forward, part, [&](std::uint32_t lower, std::span<const HalfEdge> edge) {
      const auto [low, high] = std::minmax({edge[0].face(), second[e].load(std::memory_order_relaxed) - 1});
      topology.edges[e] = {lower, edge[0].other, low, high};
      // Along a seam the contour of one face runs twice.
      topology.edge_flags[e] = low == high ? std::uint16_t{kEdgeInner} : std::uint16_t{0};
      ++e;
    });
  });
  topology.first_edges = std::move(forward.begin);
  return true;
}

void find_edges(const Scene& scene, Topology& topology) {
  if (scene.stated.has(StatedFact::adjacency) && find_paired_edges(scene, topology)) return;
  if (scene.corner_flags.empty()) {
    find_all_edges<HalfEdge>(scene, topology);
  } else {
    find_all_edges<FlaggedHalfEdge>(scene, topology);
  }
}

bool is_paired(const Topology& topology) {
  const auto bad = [&](std::size_t e) {
    return topology.edges[e].face1 == kNone || (topology.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound)) != 0;
  };
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    if (bad(e)) return false;
  }
  return true;
}

}  // namespace ligne
