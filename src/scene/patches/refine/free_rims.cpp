#include "scene/patches/refine/free_rims.hpp"

#include <algorithm>
#include <cmath>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "scene/heal/edge_tree.hpp"

namespace ligne {
namespace {

/// Open edges are neighbours where one lies nearer to the middle of the other than so many of its sags: both may be chords.
constexpr double kRimSags = 2;

}  // namespace

std::vector<std::uint32_t> free_rims(const Scene& scene, const Topology& topology, const Patches& patches,
                                     std::span<const std::uint32_t> curved) {
  const auto is_open = [&](std::uint32_t e) { return topology.edges[e].face1 == kNone; };
  if (std::ranges::none_of(curved, is_open)) return {};
  const std::vector<std::uint32_t> open =
      indices_where(topology.edges.size(), [&](std::size_t e) { return is_open(static_cast<std::uint32_t>(e)); });
  std::vector<EdgeTree::Segment> segments;
  segments.reserve(open.size());
  for (const std::uint32_t e : open)
    segments.push_back({scene.vertices[topology.edges[e].v0], scene.vertices[topology.edges[e].v1]});
  const EdgeTree tree(segments);
  std::vector<std::uint32_t> rims;
  for (const std::uint32_t e : curved) {
    if (!is_open(e)) continue;
    const Edge& edge = topology.edges[e];
    const std::uint32_t patch = patches.patch_of[edge.face0];
    if (patch == kNone) continue;
    const Point3 middle = 0.5 * (scene.vertices[edge.v0] + scene.vertices[edge.v1]);
    const double within = kRimSags * std::abs(patches.list[patch].surface.distance(middle));
    const auto is_apart = [&](std::uint32_t segment, double) {
      const Edge& other = topology.edges[open[segment]];
      return other.v0 != edge.v0 && other.v0 != edge.v1 && other.v1 != edge.v0 && other.v1 != edge.v1;
    };
    if (tree.nearest(middle, within, is_apart).segment == kNone) rims.push_back(e);
  }
  return rims;
}

}  // namespace ligne
