#include "scene/model/topology.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/large_vector.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_counting_sort.hpp"
#include "base/uninitialized_vector.hpp"
#include "geometry/triangulate.hpp"
#include "scene/model/half_edges.hpp"
#include "scene/model/paired_edges.hpp"
#include "scene/model/triangle_normal.hpp"

// Edges are found by counting sort. Every corner of a contour gives one half-edge, filed under the lower of its two
// vertices. A bucket holds the half-edges of one vertex (six on average) and is sorted by the other vertex. Half-edges
// first go into parts, each for a range of vertices, whose buckets fit the cache. Blocks of faces write into a part in
// their order. So the order within a bucket is that of the corners, at any number of threads.

namespace ligne {
namespace {

constexpr std::uint32_t kReversed = 0x80000000u;  ///< the half-edge runs from the higher vertex to the lower

struct HalfEdge {
  std::uint32_t other;               ///< the higher vertex
  std::uint32_t face_and_direction;  ///< face, with kReversed where it applies
  std::uint32_t face() const { return face_and_direction & ~kReversed; }
};

/// The half-edges by part, within a part in the order of the corners.
struct Parts {
  struct Entry {
    std::uint32_t lower;
    HalfEdge half_edge;
  };
  std::vector<std::size_t> begin;  ///< first entry of each part, and the end
  UninitializedVector<Entry> entries;
  UninitializedVector<std::uint8_t> corner_flags;  ///< per entry, if the scene has any
};

Parts sort_into_parts(const Scene& scene) {
  Parts parts;
  const bool with_flags = !scene.corner_flags.empty();
  const auto list = [&](std::size_t begin, std::size_t end, const auto& take) {
    for_each_half_edge(scene.faces, begin, end, [&](std::uint32_t a, std::uint32_t b, std::size_t face, std::size_t corner) {
      take(std::min(a, b) / kVerticesPerPart, a, b, face, corner);
    });
  };
  const auto allocate = [&](std::size_t n) {
    parts.entries = UninitializedVector<Parts::Entry>(n);
    if (with_flags) parts.corner_flags = UninitializedVector<std::uint8_t>(n);
  };
  const auto put = [&](std::size_t place, std::uint32_t a, std::uint32_t b, std::size_t face, std::size_t corner) {
    const auto [lower, higher] = std::minmax(a, b);
    parts.entries[place] = {lower, {higher, static_cast<std::uint32_t>(face) | (a > b ? kReversed : 0)}};
    if (with_flags) parts.corner_flags[place] = scene.corner_flags[corner];
  };
  const std::size_t count = block_count(scene.vertices.size(), kVerticesPerPart);
  parts.begin = parallel_counting_sort(scene.faces.size(), kFacesPerBlock, count, list, allocate, put);
  return parts;
}

struct Buckets {
  std::vector<std::uint32_t> begin;  ///< first half-edge of each vertex, and the end
  UninitializedVector<HalfEdge> half_edges;
  bool with_flags = false;
  UninitializedVector<std::uint8_t> corner_flags;  ///< parallel to half_edges, if the scene has any
};

/// Files the half-edges of a part, whose vertices are [first, last). The caller has written where the part begins and
/// ends, since other tasks read that.
void fill_buckets(const Parts& parts, std::size_t part, std::size_t first, std::size_t last, Buckets& buckets) {
  // Counts first, then the positions of the next half-edges.
  std::vector<std::uint32_t> next(last - first, 0);
  for (std::size_t i = parts.begin[part]; i < parts.begin[part + 1]; ++i) ++next[parts.entries[i].lower - first];
  auto sum = static_cast<std::uint32_t>(parts.begin[part]);
  for (std::size_t v = first; v < last; ++v) {
    sum += std::exchange(next[v - first], sum);
    if (v + 1 < last) buckets.begin[v + 1] = sum;
  }
  for (std::size_t i = parts.begin[part]; i < parts.begin[part + 1]; ++i) {
    const std::uint32_t slot = next[parts.entries[i].lower - first]++;
    buckets.half_edges[slot] = parts.entries[i].half_edge;
    if (buckets.with_flags) buckets.corner_flags[slot] = parts.corner_flags[i];
  }
}

/// Sorts the bucket [begin, end) by the other vertex. The sort is stable and moves the flags too.
void sort_bucket(Buckets& buckets, std::uint32_t begin, std::uint32_t end) {
  auto& h = buckets.half_edges;
  constexpr std::uint32_t kInsertionSortLimit = 32;
  if (end - begin > kInsertionSortLimit) {  // the hub of a large fan
    std::vector<std::pair<HalfEdge, std::uint8_t>> bucket;
    for (std::uint32_t k = begin; k < end; ++k) {
      bucket.emplace_back(h[k], buckets.with_flags ? buckets.corner_flags[k] : std::uint8_t{0});
    }
    std::stable_sort(bucket.begin(), bucket.end(),
                     [](const auto& a, const auto& b) { return a.first.other < b.first.other; });
    for (std::uint32_t k = begin; k < end; ++k) {
      h[k] = bucket[k - begin].first;
      if (buckets.with_flags) buckets.corner_flags[k] = bucket[k - begin].second;
    }
    return;
  }
  HalfEdge* const half_edges = h.data();
  std::uint8_t* const flags = buckets.with_flags ? buckets.corner_flags.data() : nullptr;
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    const HalfEdge moved = half_edges[i];
    if (!(moved.other < half_edges[i - 1].other)) continue;
    const std::uint8_t moved_flags = flags ? flags[i] : std::uint8_t{0};
    std::uint32_t k = i;
    for (; k > begin && moved.other < half_edges[k - 1].other; --k) {
      half_edges[k] = half_edges[k - 1];
      if (flags) flags[k] = flags[k - 1];
    }
    half_edges[k] = moved;
    if (flags) flags[k] = moved_flags;
  }
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

std::uint16_t flags_of_edge(const Buckets& buckets, std::uint32_t begin, std::uint32_t end) {
  std::uint16_t flags = 0;
  if (end - begin > 2) flags |= kEdgeManyFaces;
  if (end - begin == 1) flags |= kEdgeBorder;
  if (end - begin == 2) {
    const HalfEdge a = buckets.half_edges[begin], b = buckets.half_edges[begin + 1];
    // A seam: the contour of one face runs along it twice.
    if (a.face() == b.face()) return kEdgeInner;
    if ((a.face_and_direction & kReversed) == (b.face_and_direction & kReversed)) flags |= kEdgeUnlikeWound;
  }
  if (buckets.with_flags) {
    std::uint8_t common = 0xff, any = 0;  // a flag of the file holds for an edge if all its faces have it
    for (std::uint32_t k = begin; k < end; ++k) {
      common &= buckets.corner_flags[k];
      any |= buckets.corner_flags[k];
    }
    flags |= kEdgeFlags.of_any[any] | kEdgeFlags.of_all[common];
  }
  return flags;
}

void find_edges(const Scene& scene, Topology& topology) {
  const std::size_t vertex_count = scene.vertices.size();
  if (vertex_count == 0) return;
  Buckets buckets;
  // Runs of equal half-edges are edges. They are sorted and counted per part, and then every part is written at its
  // place.
  const std::size_t count = block_count(vertex_count, kVerticesPerPart);
  const auto for_each_edge_of_part = [&](std::size_t part, auto visit) {
    const std::size_t last = std::min(vertex_count, (part + 1) * kVerticesPerPart);
    for (std::size_t v = part * kVerticesPerPart; v < last; ++v) {
      for (std::uint32_t k = buckets.begin[v]; k < buckets.begin[v + 1];) {
        std::uint32_t end = k + 1;
        while (end < buckets.begin[v + 1] && buckets.half_edges[end].other == buckets.half_edges[k].other) ++end;
        visit(static_cast<std::uint32_t>(v), k, end);
        k = end;
      }
    }
  };
  std::vector<std::size_t> first_edge(count + 1, 0);
  {
    const Parts parts = sort_into_parts(scene);
    buckets.begin.resize(vertex_count + 1);
    for (std::size_t part = 0; part < count; ++part) {
      buckets.begin[part * kVerticesPerPart] = static_cast<std::uint32_t>(parts.begin[part]);
    }
    buckets.begin[vertex_count] = static_cast<std::uint32_t>(parts.begin[count]);
    buckets.half_edges = UninitializedVector<HalfEdge>(parts.begin[count]);
    buckets.with_flags = !scene.corner_flags.empty();
    if (buckets.with_flags) buckets.corner_flags = UninitializedVector<std::uint8_t>(parts.begin[count]);
    parallel_for(count, [&](std::size_t part) {
      const std::size_t first = part * kVerticesPerPart, last = std::min(vertex_count, first + kVerticesPerPart);
      fill_buckets(parts, part, first, last, buckets);
      for (std::size_t v = first; v < last; ++v) sort_bucket(buckets, buckets.begin[v], buckets.begin[v + 1]);
      for_each_edge_of_part(part, [&](std::uint32_t, std::uint32_t, std::uint32_t) { ++first_edge[part + 1]; });
    });
  }
  for (std::size_t part = 0; part < count; ++part) first_edge[part + 1] += first_edge[part];
  topology.edges = large_vector<Edge>(first_edge[count]);
  topology.edge_flags = large_vector<std::uint16_t>(first_edge[count]);
  parallel_for(count, [&](std::size_t part) {
    std::size_t e = first_edge[part];
    for_each_edge_of_part(part, [&](std::uint32_t v, std::uint32_t begin, std::uint32_t end) {
      const auto& h = buckets.half_edges;
      topology.edges[e] = {v, h[begin].other, h[begin].face(), end - begin > 1 ? h[begin + 1].face() : kNone};
      topology.edge_flags[e] = flags_of_edge(buckets, begin, end);
      ++e;
    });
  });
}

/// The two coordinates in which the polygon is largest, ordered to keep its winding.
Point2 flatten(const Point3& p, const Point3& normal) {
  const Point3 a = glm::abs(normal);
  if (a.x >= a.y && a.x >= a.z) return normal.x > 0 ? Point2{p.y, p.z} : Point2{p.z, p.y};
  if (a.y >= a.z) return normal.y > 0 ? Point2{p.z, p.x} : Point2{p.x, p.z};
  return normal.z > 0 ? Point2{p.x, p.y} : Point2{p.y, p.x};
}

void triangulate_face(const Scene& scene, std::uint32_t face, std::vector<Triangle>& out) {
  const PolygonFaces& faces = scene.faces;
  const auto outer = faces.contour(face, 0);
  if (faces.contour_count(face) == 1 && outer.size() == 3) {
    out.push_back({{outer[0], outer[1], outer[2]}, face});
    return;
  }
  const Point3 normal = face_normal(scene, face);
  std::vector<Point2> points;
  std::vector<std::uint32_t> vertices, contour_end;
  for (std::size_t c = 0; c < faces.contour_count(face); ++c) {
    for (const std::uint32_t v : faces.contour(face, c)) {
      points.push_back(flatten(scene.vertices[v], normal));
      vertices.push_back(v);
    }
    contour_end.push_back(static_cast<std::uint32_t>(points.size()));
  }
  for (const auto& t : triangulate(points, contour_end)) {
    out.push_back({{vertices[t[0]], vertices[t[1]], vertices[t[2]]}, face});
  }
}

}  // namespace

Point3 face_normal(const Scene& scene, std::uint32_t face) {
  const auto contour = scene.faces.contour(face, 0);
  const Point3 origin = scene.vertices[contour[0]];
  if (contour.size() == 3) return triangle_normal(origin, scene.vertices[contour[1]], scene.vertices[contour[2]]);
  Point3 sum{0, 0, 0};
  for (std::size_t k = 1; k + 1 < contour.size(); ++k) {
    sum += glm::cross(scene.vertices[contour[k]] - origin, scene.vertices[contour[k + 1]] - origin);
  }
  const double length = glm::length(sum);
  return length > 0 ? sum / length : Point3{0, 0, 0};
}

std::vector<Triangle> triangulate_faces(const Scene& scene) {
  std::vector<Triangle> triangles;
  const std::size_t n = scene.faces.size();
  if (scene.faces.all_triangles()) {
    triangles = large_vector<Triangle>(n);
    const auto corners = scene.faces.corners();
    parallel_blocks(n, 65'536, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        triangles[f] = {{corners[3 * f], corners[3 * f + 1], corners[3 * f + 2]}, static_cast<std::uint32_t>(f)};
      }
    });
  } else {
    triangles.reserve(n * 2);
    for (std::uint32_t f = 0; f < n; ++f) triangulate_face(scene, f, triangles);
  }
  return triangles;
}

std::uint16_t flags_of_any(const Topology& topology) {
  // There is no early exit, so that the loop can be vectorized.
  return std::accumulate(topology.edge_flags.begin(), topology.edge_flags.end(), std::uint16_t{0}, std::bit_or<>{});
}

std::vector<std::uint32_t> edges_with(const Topology& topology, unsigned flags) {
  return indices_of_marks(topology.edge_flags, flags);
}

EdgeRange edges_of(const Topology& topology, const Object& object) {
  const auto first_from = [&topology](std::uint32_t vertex) {
    const auto at = std::ranges::lower_bound(topology.edges, vertex, {}, &Edge::v0);
    return static_cast<std::uint32_t>(at - topology.edges.begin());
  };
  return {first_from(object.vertex_begin), first_from(object.vertex_end)};
}

EdgeRange edges_up_from(const Topology& topology, std::uint32_t vertex) {
  const std::vector<std::uint32_t>& first = topology.first_edges;
  if (!first.empty()) return {first[vertex], first[vertex + 1]};
  const auto from = std::ranges::lower_bound(topology.edges, vertex, {}, &Edge::v0);
  const auto to = std::ranges::upper_bound(topology.edges, vertex, {}, &Edge::v0);
  return {static_cast<std::uint32_t>(from - topology.edges.begin()),
          static_cast<std::uint32_t>(to - topology.edges.begin())};
}

void index_edges(Topology& topology, std::size_t vertices) {
  const std::size_t n = topology.edges.size();
  topology.first_edges = large_vector<std::uint32_t>(vertices + 1);
  parallel_blocks(n + 1, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const std::size_t from = e > 0 ? std::size_t{topology.edges[e - 1].v0} + 1 : 0;
      const std::size_t last = e < n ? topology.edges[e].v0 : vertices;
      for (std::size_t v = from; v <= last; ++v) topology.first_edges[v] = static_cast<std::uint32_t>(e);
    }
  });
}

const Edge* find_edge(const Topology& topology, std::pair<std::uint32_t, std::uint32_t> ends) {
  const auto key_of = [](std::uint32_t low, std::uint32_t high) { return std::uint64_t{low} << 32 | high; };
  const auto [low, high] = std::minmax(ends.first, ends.second);
  const std::uint64_t key = key_of(low, high);
  const std::vector<std::uint32_t>& first = topology.first_edges;
  const Edge* at = topology.edges.data() + (first.empty() ? 0 : first[low]);
  std::size_t count = first.empty() ? topology.edges.size() : first[low + 1] - first[low];
  // A binary search without branches.
  while (count > 1) {
    const std::size_t half = count / 2;
    const Edge& middle = at[half];
    at = key_of(middle.v0, middle.v1) <= key ? at + half : at;
    count -= half;
  }
  return count == 1 && at->v0 == low && at->v1 == high ? at : nullptr;
}

Topology build_topology(const Scene& scene) {
  Topology topology;
  const bool paired = scene.stated.has(StatedFact::adjacency) && find_paired_edges(scene, topology);
  if (!paired) find_edges(scene, topology);
  topology.triangles = triangulate_faces(scene);
  index_edges(topology, scene.vertices.size());
  return topology;
}

}  // namespace ligne
