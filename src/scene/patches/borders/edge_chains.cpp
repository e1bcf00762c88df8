#include "scene/patches/borders/edge_chains.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

bool go_straight_on(const Scene& scene, const Edge& a, const Edge& b, std::uint32_t vertex) {
  const auto away = [&](const Edge& edge) {
    return glm::normalize(scene.vertices[other_end(edge, vertex)] - scene.vertices[vertex]);
  };
  return glm::dot(away(a), away(b)) <= -kChainCosine;
}

}  // namespace

DisjointSets edge_chains(const Scene& scene, const Topology& topology, std::span<const BorderEdge> borders) {
  struct End {
    std::uint32_t vertex, owner, border;
    auto operator<=>(const End&) const = default;
  };
  std::vector<End> ends;
  ends.reserve(2 * borders.size());
  for (std::uint32_t i = 0; i < borders.size(); ++i) {
    const Edge& edge = topology.edges[borders[i].edge];
    for (const std::uint32_t v : {edge.v0, edge.v1}) ends.push_back({v, borders[i].owner, i});
  }
  std::ranges::sort(ends);
  DisjointSets chains(borders.size());
  for (std::size_t i = 0, last = 0; i < ends.size(); i = last) {
    while (last < ends.size() && ends[last].vertex == ends[i].vertex && ends[last].owner == ends[i].owner) ++last;
    if (last - i != 2) continue;
    const std::uint32_t a = ends[i].border, b = ends[i + 1].border;
    if (go_straight_on(scene, topology.edges[borders[a].edge], topology.edges[borders[b].edge], ends[i].vertex)) {
      chains.join(a, b);
    }
  }
  return chains;
}

}  // namespace ligne
