#include "scene/heal/border_edges.hpp"

#include <algorithm>

#include "base/hash.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "base/vertex_pair_index.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

/// Maps vertices to distinct numbers without a pattern that could cancel in sums: two rounds of multiplication.
std::uint64_t scatter(std::uint32_t v) { return mix_bits(v + kGoldenRatio); }

}  // namespace

std::vector<std::uint8_t> ends_of_odd_edges(const Scene& scene) {
  // The sums do not depend on the division into parts, since exclusive or is commutative.
  constexpr std::size_t kFacesPerPart = 100'000, kMostParts = 4;
  const PolygonFaces& faces = scene.faces;
  const std::size_t n = faces.size(), vertices = scene.vertices.size();
  const std::size_t parts = std::clamp<std::size_t>(n / kFacesPerPart, 1, std::min(kMostParts, thread_count()));
  std::vector<std::vector<std::uint64_t>> sums(parts);
  parallel_tasks(parts, [&](std::size_t part) {
    std::vector<std::uint64_t>& sum = sums[part];
    sum.assign(vertices, 0);
    const std::size_t begin = n * part / parts, end = n * (part + 1) / parts;
    if (faces.all_triangles()) {
      const std::span<const std::uint32_t> corners = faces.corners();
      for (std::size_t k = 3 * begin; k < 3 * end; k += 3) {
        const std::uint32_t a = corners[k], b = corners[k + 1], c = corners[k + 2];
        const std::uint64_t of_a = scatter(a), of_b = scatter(b), of_c = scatter(c);
        sum[a] ^= of_b ^ of_c;
        sum[b] ^= of_c ^ of_a;
        sum[c] ^= of_a ^ of_b;
      }
      return;
    }
    for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f) {
      for_sides(faces, f, [&](std::uint32_t a, std::uint32_t b) {
        sum[a] ^= scatter(b);
        sum[b] ^= scatter(a);
      });
    }
  });
  std::vector<std::uint8_t> marked(vertices);
  parallel_each(vertices, [&](std::size_t v) {
    std::uint64_t sum = 0;
    for (const auto& of_part : sums) sum ^= of_part[v];
    marked[v] = sum != 0;
  });
  return marked;
}

std::vector<std::uint8_t> ends_of_odd_edges(const Scene& scene, const Topology& topology) {
  std::vector<std::uint8_t> marked(scene.vertices.size());
  for (const std::uint32_t e : edges_with(topology, kEdgeBorder)) {
    marked[topology.edges[e].v0] = marked[topology.edges[e].v1] = 1;
  }
  return marked;
}

std::vector<std::uint32_t> faces_at(const Scene& scene, const std::vector<std::uint8_t>& marked) {
  const PolygonFaces& faces = scene.faces;
  const std::span<const std::uint32_t> corners = faces.corners();
  if (std::ranges::find(marked, 1) == marked.end()) return {};
  if (faces.all_triangles()) {
    return indices_where(faces.size(), [&](std::size_t f) {
      return (marked[corners[3 * f]] | marked[corners[3 * f + 1]] | marked[corners[3 * f + 2]]) != 0;
    });
  }
  return indices_where(faces.size(), [&](std::size_t f) {
    return std::ranges::any_of(corners_of(faces, f), [&](std::uint32_t v) { return marked[v] != 0; });
  });
}

std::span<const std::uint32_t> faces_of(const Object& object, std::span<const std::uint32_t> faces) {
  const auto first = std::ranges::lower_bound(faces, object.face_begin);
  return {first, std::ranges::lower_bound(first, faces.end(), object.face_end)};
}

std::vector<std::vector<Edge>> border_edges(const Scene& scene, const Topology& topology) {
  std::vector<std::vector<Edge>> borders(scene.objects.size());
  std::size_t object = 0;
  for (const std::uint32_t e : edges_with(topology, kEdgeBorder)) {
    // Objects own ascending ranges of the vertices, and edges are sorted by their vertices.
    while (topology.edges[e].v0 >= scene.objects[object].vertex_end) ++object;
    borders[object].push_back(topology.edges[e]);
  }
  return borders;
}

std::vector<Edge> border_edges(const Scene& scene, const Object& object, const std::vector<std::uint8_t>& marked,
                               std::span<const std::uint32_t> faces) {
  std::vector<std::uint32_t> vertices, number(object.vertex_end - object.vertex_begin, kNone);
  for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
    if (!marked[v]) continue;
    number[v - object.vertex_begin] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(v);
  }
  struct Side {
    std::uint32_t from, to, face;
  };
  std::vector<Side> sides;
  for (const std::uint32_t f : faces) {
    for_sides(scene.faces, f, [&](std::uint32_t a, std::uint32_t b) {
      const std::uint32_t from = number[a - object.vertex_begin], to = number[b - object.vertex_begin];
      if (from != kNone && to != kNone) sides.push_back({from, to, f});
    });
  }
  const VertexPairIndex filed(vertices.size(), sides.size(), [&](const auto& add) {
    for (const Side& side : sides) add(side.from, side.to, side.face);
  });
  std::vector<Edge> borders;
  filed.for_each_pair(0, vertices.size(), [&](std::uint32_t low, std::span<const VertexPairIndex::Entry> pair) {
    if (pair.size() == 1) borders.push_back({vertices[low], vertices[pair[0].high], pair[0].item, kNone});
  });
  return borders;
}

}  // namespace ligne
