#include "scene/creases/loose_creases.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "scene/model/object_sizes.hpp"

namespace ligne {
namespace {

/// Adjustable: loose creases shorter than this part of their object go. They look like scratches.
constexpr double kLoosePart = 1.0 / 8;

}  // namespace

std::vector<std::uint32_t> FreeEnds::list() const {
  std::vector<std::uint32_t> found;
  for (std::size_t first = 0, last = 0; first < ends_.size(); first = last) {
    std::size_t creases = 0;
    for (last = first; last < ends_.size() && ends_[last].vertex == ends_[first].vertex; ++last)
      creases += is_crease(ends_[last].edge);
    if (creases == 1) found.push_back(ends_[first].vertex);
  }
  return found;
}

std::uint32_t FreeEnds::only_crease_at(std::uint32_t vertex, std::uint32_t except) const {
  std::uint32_t found = kNone;
  for (auto end = std::lower_bound(ends_.begin(), ends_.end(), BendEnd{vertex, 0});
       end != ends_.end() && end->vertex == vertex; ++end) {
    if (end->edge == except || !is_crease(end->edge)) continue;
    if (found != kNone) return kNone;
    found = end->edge;
  }
  return found;
}

std::size_t drop_loose_creases(const Scene& scene, const Topology& topology, const LooseEdges& edges,
                               std::vector<Bend>& bends) {
  const FreeEnds free(topology, edges.ends, bends, edges.is_anchor);
  const auto is_smooth = [&](std::uint32_t e) {
    return bends[e] == Bend::firm && (topology.edge_flags[e] & kEdgeSmooth) != 0;
  };
  const auto is_loose = [&](std::uint32_t tip, const FreeEnds::Run& run) {
    if (run.edges.empty()) return false;
    double length = 0;
    for (const std::uint32_t e : run.edges)
      length += glm::distance(scene.vertices[topology.edges[e].v0], scene.vertices[topology.edges[e].v1]);
    if (length >= kLoosePart * edges.sizes[object_of_vertex(scene, tip)]) return false;
    if (std::ranges::all_of(run.edges, is_smooth)) return true;
    const bool is_firm = std::ranges::any_of(run.edges, [&](std::uint32_t e) { return bends[e] == Bend::firm; });
    return !is_firm && run.end != tip && free.is_free(run.end);
  };
  std::size_t dropped = 0;
  for (std::vector<std::uint32_t> tips = free.list(); !tips.empty();) {
    std::vector<std::uint32_t> gone, left;
    for (const std::uint32_t tip : tips) {
      if (!free.is_free(tip)) continue;
      const FreeEnds::Run run = free.run_from(tip, edges.may_go);
      if (!is_loose(tip, run)) continue;
      gone.insert(gone.end(), run.edges.begin(), run.edges.end());
      left.push_back(run.end);
    }
    for (const std::uint32_t e : gone) {
      dropped += free.is_crease(e);
      bends[e] = Bend::weak;
    }
    tips = std::move(left);
  }
  return dropped;
}

}  // namespace ligne
