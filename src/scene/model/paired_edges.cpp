#include "scene/model/paired_edges.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/large_vector.hpp"
#include "base/parallel.hpp"
#include "base/parallel_counting_sort.hpp"
#include "base/uninitialized_vector.hpp"
#include "scene/model/half_edges.hpp"

// Half-edges that run from the lower vertex to the higher one are filed as in topology.cpp, first by parts and then by
// their lower vertex, and sorted by the higher one. Each is an edge of its own if the fact holds, so its place in the list
// is the number of the edge. A half-edge that runs the other way looks for its edge in the bucket of its lower vertex, and
// enters its face there. The fact holds if as many run either way, no two of the first are equal, and no two of the others
// find one edge.

namespace ligne {
namespace {

struct ForwardEdge {
  std::uint32_t lower, higher, face;
};

/// The half-edges that run upwards, by part, and the first of each part, and the end.
struct ForwardEdges {
  UninitializedVector<ForwardEdge> by_part;
  std::vector<std::size_t> part_begin;
};

ForwardEdges sort_forward_edges(const Scene& scene) {
  ForwardEdges forward;
  const auto list = [&](std::size_t begin, std::size_t end, const auto& take) {
    for_each_half_edge(scene.faces, begin, end, [&](std::uint32_t a, std::uint32_t b, std::size_t face, std::size_t) {
      if (a < b) take(a / kVerticesPerPart, ForwardEdge{a, b, static_cast<std::uint32_t>(face)});
    });
  };
  const auto allocate = [&](std::size_t n) { forward.by_part = UninitializedVector<ForwardEdge>(n); };
  const auto put = [&](std::size_t place, const ForwardEdge& edge) { forward.by_part[place] = edge; };
  const std::size_t parts = block_count(scene.vertices.size(), kVerticesPerPart);
  forward.part_begin = parallel_counting_sort(scene.faces.size(), kFacesPerBlock, parts, list, allocate, put);
  return forward;
}

/// Writes the edges of a part, sorted, and where its vertices begin. False if two of them are equal.
bool write_part(const ForwardEdges& forward, std::size_t part, std::size_t first, std::size_t last,
                std::vector<std::uint32_t>& begin, std::vector<Edge>& edges) {
  const std::size_t from = forward.part_begin[part], to = forward.part_begin[part + 1];
  std::vector<std::uint32_t> next(last - first, 0);
  for (std::size_t i = from; i < to; ++i) ++next[forward.by_part[i].lower - first];
  auto sum = static_cast<std::uint32_t>(from);
  for (std::size_t v = first; v < last; ++v) {
    begin[v] = sum;
    sum += std::exchange(next[v - first], sum);
  }
  for (std::size_t i = from; i < to; ++i) {
    const ForwardEdge& f = forward.by_part[i];
    edges[next[f.lower - first]++] = {f.lower, f.higher, f.face, kNone};
  }
  bool distinct = true;
  for (std::size_t v = first; v < last; ++v) {
    const auto bucket = edges.begin() + begin[v];
    const auto end = edges.begin() + (v + 1 < last ? begin[v + 1] : static_cast<std::uint32_t>(to));
    const auto by_higher = [](const Edge& a, const Edge& b) { return a.v1 < b.v1; };
    std::sort(bucket, end, by_higher);
    distinct = distinct && std::adjacent_find(bucket, end, [](const Edge& a, const Edge& b) { return a.v1 == b.v1; }) == end;
  }
  return distinct;
}

/// Finds the edge a-b, a < b, in the bucket of its lower vertex; kNone if there is none.
std::uint32_t edge_between(const std::vector<Edge>& edges, const std::vector<std::uint32_t>& begin, std::uint32_t a,
                           std::uint32_t b) {
  std::uint32_t from = begin[a], to = begin[a + 1];
  constexpr std::uint32_t kLinearSearchLimit = 16;
  while (to - from > kLinearSearchLimit) {  // the hub of a large fan
    const std::uint32_t middle = from + (to - from) / 2;
    (edges[middle].v1 <= b ? from : to) = middle;
  }
  for (; from < to; ++from) {
    if (edges[from].v1 == b) return from;
  }
  return kNone;
}

/// Enters the second faces. False if the half-edges that run downwards are not one for each edge.
bool pair_up(const Scene& scene, const std::vector<std::uint32_t>& begin, std::vector<Edge>& edges) {
  std::vector<std::atomic<std::uint32_t>> second(edges.size());
  std::atomic<std::size_t> pairs = 0;
  parallel_blocks(scene.faces.size(), kFacesPerBlock, [&](std::size_t first, std::size_t last) {
    std::size_t found = 0;
    for_each_half_edge(scene.faces, first, last, [&](std::uint32_t a, std::uint32_t b, std::size_t face, std::size_t) {
      if (a < b) return;
      const std::uint32_t edge = edge_between(edges, begin, b, a);
      if (edge == kNone) return;
      found += second[edge].exchange(static_cast<std::uint32_t>(face) + 1, std::memory_order_relaxed) == 0;
    });
    pairs += found;
  });
  if (pairs != edges.size()) return false;
  parallel_blocks(edges.size(), kFacesPerBlock, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e) {
      const std::uint32_t other = second[e].load(std::memory_order_relaxed) - 1;
      edges[e].face1 = std::max(edges[e].face0, other);
      edges[e].face0 = std::min(edges[e].face0, other);
    }
  });
  return true;
}

}  // namespace

bool find_paired_edges(const Scene& scene, Topology& topology) {
  const std::size_t corners = scene.faces.corners().size(), vertices = scene.vertices.size();
  if (!scene.corner_flags.empty() || corners == 0) return false;
  const ForwardEdges forward = sort_forward_edges(scene);
  const std::size_t count = forward.part_begin.back();
  if (2 * count != corners) return false;
  std::vector<Edge> edges = large_vector<Edge>(count);
  std::vector<std::uint32_t> begin(vertices + 1);
  begin[vertices] = static_cast<std::uint32_t>(edges.size());
  std::atomic<bool> distinct = true;
  parallel_for(forward.part_begin.size() - 1, [&](std::size_t part) {
    const std::size_t first = part * kVerticesPerPart, last = std::min(vertices, first + kVerticesPerPart);
    if (!write_part(forward, part, first, last, begin, edges)) distinct = false;
  });
  if (!distinct || !pair_up(scene, begin, edges)) return false;
  topology.edge_flags = large_vector<std::uint16_t>(edges.size());
  // Along a seam the contour of one face runs twice.
  parallel_blocks(edges.size(), kFacesPerBlock, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e) {
      topology.edge_flags[e] = edges[e].face0 == edges[e].face1 ? std::uint16_t{kEdgeInner} : std::uint16_t{0};
    }
  });
  topology.edges = std::move(edges);
  return true;
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
