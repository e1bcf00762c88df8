#include "scene/heal/border_edges.hpp"

#include <span>

#include "geometry/filed_pairs.hpp"
#include "geometry/indices_where.hpp"

namespace ligne {

std::vector<std::vector<Edge>> border_edges(const Scene& scene, const Topology& topology) {
  std::vector<std::vector<Edge>> borders(scene.objects.size());
  std::size_t object = 0;
  const auto is_border = [&](std::size_t e) { return topology.edges[e].face1 == kNone; };
  for (const std::uint32_t e : indices_where(topology.edges.size(), is_border)) {
    // Objects own ascending ranges of the vertices, and edges come in the order of their vertices.
    while (topology.edges[e].v0 >= scene.objects[object].vertex_end) ++object;
    borders[object].push_back(topology.edges[e]);
  }
  return borders;
}

std::vector<Edge> border_edges(const Scene& scene, const Object& object, const std::vector<std::uint8_t>& marked) {
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
  const auto number_of = [&](std::uint32_t v) { return number[v - object.vertex_begin]; };
  const auto add_side = [&](std::uint32_t from, std::uint32_t to, std::uint32_t f) {
    if (from != kNone && to != kNone) sides.push_back({from, to, f});
  };
  const bool triangles = scene.faces.all_triangles();
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  for (std::uint32_t f = object.face_begin; triangles && f < object.face_end; ++f) {
    const std::uint32_t* v = &corners[3 * std::size_t{f}];
    const std::uint32_t a = number_of(v[0]), b = number_of(v[1]), c = number_of(v[2]);
    add_side(a, b, f);
    add_side(b, c, f);
    add_side(c, a, f);
  }
  for (std::uint32_t f = object.face_begin; !triangles && f < object.face_end; ++f) {
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      std::uint32_t from = number_of(contour.back());
      for (const std::uint32_t v : contour) {
        const std::uint32_t to = number_of(v);
        add_side(from, to, f);
        from = to;
      }
    }
  }
  const FiledPairs filed(vertices.size(), sides.size(), [&](const auto& add) {
    for (const Side& side : sides) add(side.from, side.to, side.face);
  });
  std::vector<Edge> borders;
  filed.for_each_pair(0, vertices.size(), [&](std::uint32_t low, std::span<const FiledPairs::Entry> pair) {
    if (pair.size() == 1) borders.push_back({vertices[low], vertices[pair[0].high], pair[0].thing, kNone});
  });
  return borders;
}

}  // namespace ligne
