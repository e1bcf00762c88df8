#include "scene/heal/border_edges.hpp"

#include <span>
#include <utility>

#include "geometry/filed_pairs.hpp"

namespace ligne {
namespace {

/// Files edges by their objects, which own ascending ranges of the vertices. Edges come in the order of their vertices.
class ObjectEdges {
 public:
  explicit ObjectEdges(const Scene& scene) : scene_(scene), edges_(scene.objects.size()) {}

  void add(const Edge& edge) {
    while (edge.v0 >= scene_.objects[object_].vertex_end) ++object_;
    edges_[object_].push_back(edge);
  }
  std::vector<std::vector<Edge>> take() { return std::move(edges_); }

 private:
  const Scene& scene_;
  std::vector<std::vector<Edge>> edges_;
  std::size_t object_ = 0;
};

}  // namespace

std::vector<std::vector<Edge>> border_edges(const Scene& scene, const Topology& topology) {
  ObjectEdges borders(scene);
  for (const Edge& edge : topology.edges) {
    if (edge.face1 == kNone) borders.add(edge);
  }
  return borders.take();
}

std::vector<std::vector<Edge>> border_edges(const Scene& scene, const std::vector<std::uint8_t>& marked) {
  std::vector<std::uint32_t> vertices, number(marked.size(), kNone);
  for (std::uint32_t v = 0; v < marked.size(); ++v) {
    if (!marked[v]) continue;
    number[v] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(v);
  }
  struct Side {
    std::uint32_t from, to, face;
  };
  std::vector<Side> sides;
  const auto add_side = [&](std::uint32_t from, std::uint32_t to, std::uint32_t f) {
    if (from != kNone && to != kNone) sides.push_back({from, to, f});
  };
  const bool triangles = scene.faces.all_triangles();
  const std::span<const std::uint32_t> corners = scene.faces.corners();
  for (std::uint32_t f = 0; triangles && f < scene.faces.size(); ++f) {
    const std::uint32_t* v = &corners[3 * std::size_t{f}];
    const std::uint32_t a = number[v[0]], b = number[v[1]], c = number[v[2]];
    add_side(a, b, f);
    add_side(b, c, f);
    add_side(c, a, f);
  }
  for (std::uint32_t f = 0; !triangles && f < scene.faces.size(); ++f) {
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      std::uint32_t from = number[contour.back()];
      for (const std::uint32_t v : contour) {
        const std::uint32_t to = number[v];
        add_side(from, to, f);
        from = to;
      }
    }
  }
  const FiledPairs filed(vertices.size(), sides.size(), [&](const auto& add) {
    for (const Side& side : sides) add(side.from, side.to, side.face);
  });
  ObjectEdges borders(scene);
  filed.for_each_pair(0, vertices.size(), [&](std::uint32_t low, std::span<const FiledPairs::Entry> pair) {
    if (pair.size() == 1) borders.add({vertices[low], vertices[pair[0].high], pair[0].thing, kNone});
  });
  return borders.take();
}

}  // namespace ligne
