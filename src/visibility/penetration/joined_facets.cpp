#include "visibility/penetration/joined_facets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/indices_where.hpp"
#include "base/large_vector.hpp"
#include "base/no_index.hpp"
#include "base/parallel_each.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {
namespace {

/// Per face: the sense in which its corners turn on the page, 1 or -1; 0 if it has no facet. `facets`: of the triangles in
/// their order, without those that have no area.
std::vector<std::int8_t> turns_of_faces(const std::vector<Triangle>& triangles, const std::vector<Facet>& facets) {
  std::vector<std::int8_t> turns(triangles.size());
  auto t = triangles.begin();
  for (const Facet& f : facets) {
    while (t->face != f.face) ++t;
    turns[f.face] = t->v[1] == f.v[1] ? 1 : -1;
  }
  return turns;
}

/// Whether a facet lies nowhere in a square behind `depth`.
bool ends_before(const ProjectedScene& scene, const Facet& f, const CellSquare& square, double reach, double depth) {
  if (f.z_far <= depth) return true;
  const FacetFunctions g(f, scene.vertices.data());
  const double half = square.size / 2, z = g.depth(square.x + half, square.y + half);
  return z + (std::abs(g.zx) + std::abs(g.zy)) * reach + g.slack <= depth;
}

/// Values of joined_facets() by the sense in which facets turn: to the left, not at all, to the right.
constexpr std::array<std::uint8_t, 3> kSenses{1, 0, 2};

/// Whether the centre of a square lies in a facet, or on its border.
struct AtCentre {
  bool inside = false, on_border = false;
};
AtCentre at_centre(const ProjectedScene& scene, const Facet& f, LatticePoint centre) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const LatticePoint from = scene.vertices[f.v[i]].p, to = scene.vertices[f.v[i == 2 ? 0 : i + 1]].p;
    least = std::min(least, orientation(from, to, centre));
  }
  return {least > 0, least == 0};
}

}  // namespace

std::vector<std::uint8_t> joined_facets(const ProjectedScene& scene, const Topology& topology,
                                        const std::vector<Facet>& facets) {
  const std::size_t n = topology.triangles.size();
  const bool is_whole = scene.model && scene.model->faces.all_triangles() && scene.triangles.size() == n &&
                        scene.vertices.size() == scene.model->vertices.size();
  if (!is_whole || !edges_with(topology, kEdgeManyFaces).empty()) return {};
  std::vector<std::int8_t> turns = turns_of_faces(scene.triangles, facets);
  const std::vector<std::uint32_t> loose = indices_where(topology.edges.size(), [&](std::size_t e) {
    const Edge& edge = topology.edges[e];
    return edge.face1 == kNone || turns[edge.face0] != turns[edge.face1] || (topology.edge_flags[e] & kEdgeUnlikeWound);
  });
  for (const std::uint32_t e : loose) {
    for (const std::uint32_t f : {topology.edges[e].face0, topology.edges[e].face1}) {
      if (f != kNone) turns[f] = 0;
    }
  }
  std::vector<std::uint8_t> joined = large_vector<std::uint8_t>(facets.size());
  parallel_each(facets.size(), [&](std::size_t i) { joined[i] = kSenses[turns[facets[i].face] + 1]; });
  return joined;
}

bool has_layers_apart(const ProjectedScene& scene, const std::vector<Facet>& facets, std::span<const std::uint8_t> joined,
                      const ListedLeaf& leaf) {
  const auto sense = [&](const CellFacet& listed) { return joined[listed.facet]; };
  // The facets in front, and those behind them, which turn in the other sense.
  const std::uint8_t front = sense(leaf.list.front());
  const auto behind = std::ranges::find_if(
      leaf.list, [&](std::uint8_t s) { return s != front; }, sense);
  const bool is_mixed =
      std::any_of(behind, leaf.list.end(), [&](const CellFacet& c) { return sense(c) == 0 || sense(c) == front; });
  if (front == 0 || is_mixed || leaf.cell.dropped_by_planes) return false;
  const double half = leaf.square.size / 2, reach = half + leaf.margin;
  const LatticePoint centre{static_cast<std::int32_t>(leaf.square.x + half),
                            static_cast<std::int32_t>(leaf.square.y + half)};
  const CellBox centre_box = leaf.square.box(centre.x, centre.x, centre.y, centre.y);
  const float end_of_front = behind == leaf.list.end() ? std::numeric_limits<float>::infinity() : behind->z_near;
  bool is_covered = false;
  for (auto listed = leaf.list.begin(); listed != leaf.list.end(); ++listed) {
    if (listed == behind) is_covered = false;
    const Facet& f = facets[listed->facet];
    if (listed < behind && !(f.z_far < end_of_front)) return false;
    // The neighbours of a facet that ends before the cover begin before it, and so are listed.
    if (!ends_before(scene, f, leaf.square, reach, leaf.cell.occluder_depth)) return false;
    if (!listed->box.meets(centre_box)) continue;
    const auto [inside, on_border] = at_centre(scene, f, centre);
    if (on_border || (inside && std::exchange(is_covered, true))) return false;
  }
  return true;
}

}  // namespace ligne
