#include "contours/contour_choice.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "contours/contour_support.hpp"
#include "contours/surfaces/known_surfaces.hpp"

namespace ligne {
namespace {

/// Smallest turn of a polyline that counts as a corner, in radians. Rounding to float32 turns short edges by about this
/// much.
constexpr double kStraightTurn = 5e-3;

/// Adjustable. Mean distance of the contours from the mesh above which the mesh is coarse, in pen widths. In groups of
/// at most kFewNodes nodes, the mean sag is compared instead. In all groups a mean sag above kSagInPens is coarse.
constexpr double kCoarseInPens = 2;
constexpr double kSagInPens = 4;
constexpr std::size_t kFewNodes = 8;
/// Adjustable. Largest fraction of the contours' length that may stray from the outline of the mesh. With more, the
/// contours belong to another shape.
constexpr double kMostAstray = 0.25;

/// A connected group of contours and outline edges, by their indices.
struct Group {
  std::vector<std::uint32_t> chains, sides;
};

/// Counts the corners of a polyline.
std::size_t turns(const std::vector<Point2>& line) {
  std::size_t count = 0;
  Point2 last{0, 0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point2 d = line[i] - line[i - 1];
    if (glm::dot(d, d) == 0) continue;
    const double turn = std::abs(std::atan2(last.x * d.y - last.y * d.x, glm::dot(last, d)));
    if (glm::dot(last, last) > 0 && turn > kStraightTurn) ++count;
    last = d;
  }
  return count;
}

class Chooser {
 public:
  Chooser(const Scene& scene, const View& view, const SmoothPatch& patch, std::vector<ContourChain>& chains,
          const std::vector<OutlineSide>& sides)
      : scene_(scene), view_(view), patch_(patch), chains_(chains), sides_(sides) {}

  std::vector<Group> groups() {
    const auto sectors = static_cast<std::uint32_t>(patch_.normals.size());
    DisjointSets sets(sectors + chains_.size());
    std::vector<std::uint8_t> on_outline(sectors, 0);
    for (const OutlineSide& s : sides_) {
      const std::uint32_t a = patch_.sector[s.side], b = patch_.sector[next_corner(s.side)];
      on_outline[a] = on_outline[b] = 1;
      sets.join(a, b);
    }
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
      for (const std::uint32_t t : chains_[c].triangles) {
        for (std::uint32_t k = 3 * t; k < 3 * t + 3; ++k) {
          if (on_outline[patch_.sector[k]]) sets.join(sectors + c, patch_.sector[k]);
        }
      }
    }
    std::vector<std::uint32_t> number(sectors + chains_.size(), kNone);
    std::vector<Group> groups;
    const auto group_of = [&](std::uint32_t member) -> Group& {
      std::uint32_t& n = number[sets.find(member)];
      if (n == kNone) {
        n = static_cast<std::uint32_t>(groups.size());
        groups.emplace_back();
      }
      return groups[n];
    };
    for (std::uint32_t c = 0; c < chains_.size(); ++c) group_of(sectors + c).chains.push_back(c);
    for (std::uint32_t i = 0; i < sides_.size(); ++i) group_of(patch_.sector[sides_[i].side]).sides.push_back(i);
    return groups;
  }

  /// The contours that replace the outline of a group; nothing if the outline stays. Moves them out of the chains.
  std::optional<std::vector<ContourChain>> replacement(const Group& group, double pen_width_mm) const {
    if (outline_is_clean(group) || stands_edge_on(group)) return std::nullopt;
    std::vector<ContourChain*> chains;
    std::vector<std::uint32_t> sides;
    for (const std::uint32_t c : group.chains) chains.push_back(&chains_[c]);
    for (const std::uint32_t i : group.sides) sides.push_back(sides_[i].side);
    const ContourSupport support(scene_, view_, patch_, chains, sides, pen_width_mm);
    const double sag_mm = support.mean_sag_mm();
    const double beside_mm = support.nodes() > kFewNodes ? support.mean_lift_mm() : sag_mm;
    const bool is_coarse = (beside_mm > kCoarseInPens * pen_width_mm && !lies_on_one_surface(group)) ||
                           (sag_mm > kSagInPens * pen_width_mm && !lies_on_surfaces(group));
    if (is_coarse || support.astray() > kMostAstray) return std::nullopt;
    return support.supported();
  }

 private:
  /// Whether the mesh's outline is a simple path between the ends of the group's only contour, with at most one corner.
  bool outline_is_clean(const Group& group) const {
    if (group.chains.size() != 1 || group.sides.empty()) return false;
    const ContourChain& chain = chains_[group.chains[0]];
    const std::uint32_t from = chain.nodes.front().meets, to = chain.nodes.back().meets;
    if (chain.closed || from == kNone || to == kNone || from == to) return false;
    const std::vector<Point2> path = simple_path(group, from, to);
    return !path.empty() && turns(path) <= 1;
  }

  /// Whether all contours of the group lie on recognised surfaces, of which there may be several.
  bool lies_on_surfaces(const Group& group) const {
    return std::ranges::all_of(group.chains, [&](std::uint32_t c) {
      return std::ranges::all_of(chains_[c].triangles, [&](std::uint32_t t) { return surface_at(patch_, t) != nullptr; });
    });
  }

  /// Whether all contours of the group lie on one recognised surface.
  bool lies_on_one_surface(const Group& group) const {
    if (group.chains.empty()) return false;
    const Patch* const first = surface_at(patch_, chains_[group.chains[0]].triangles[0]);
    return first && std::ranges::all_of(group.chains, [&](std::uint32_t c) {
             return std::ranges::all_of(chains_[c].triangles,
                                        [&](std::uint32_t t) { return surface_at(patch_, t) == first; });
           });
  }

  /// Whether a triangle at the group's edges is seen edge on. Groups whose contours are all closed are excepted.
  bool stands_edge_on(const Group& group) const {
    const bool closed = !group.chains.empty() && std::all_of(group.chains.begin(), group.chains.end(),
                                                             [&](std::uint32_t c) { return chains_[c].closed; });
    return !closed && std::any_of(group.sides.begin(), group.sides.end(), [&](std::uint32_t i) {
      const std::uint32_t side = sides_[i].side;
      return patch_.facing[side / 3] == 0 || patch_.facing[patch_.across[side] / 3] == 0;
    });
  }

  std::uint32_t vertex(std::uint32_t corner) const { return patch_.triangles[corner / 3].v[corner % 3]; }

  /// The edges of the group as one path between two vertices; empty if they do not form one.
  std::vector<Point2> simple_path(const Group& group, std::uint32_t from, std::uint32_t to) const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> arms;  // each edge from both of its ends
    for (const std::uint32_t i : group.sides) {
      const std::uint32_t side = sides_[i].side;
      // A triangle that is seen edge on has outlines on both sides; one of them will do.
      if ((patch_.facing[side / 3] >= 0) == (patch_.facing[patch_.across[side] / 3] >= 0)) continue;
      const std::uint32_t a = vertex(side), b = vertex(next_corner(side));
      arms.emplace_back(a, b);
      arms.emplace_back(b, a);
    }
    std::sort(arms.begin(), arms.end());
    std::vector<Point2> path{page_point(view_, scene_.vertices[from])};
    std::uint32_t before = kNone, at = from;
    for (std::size_t steps = 0; steps < arms.size() / 2; ++steps) {
      const auto first = std::lower_bound(arms.begin(), arms.end(), std::pair(at, 0u));
      std::uint32_t next = kNone, count = 0;
      for (auto arm = first; arm != arms.end() && arm->first == at; ++arm, ++count) {
        if (arm->second != before) next = arm->second;
      }
      if (next == kNone || count != (at == from ? 1u : 2u)) return {};
      before = std::exchange(at, next);
      path.push_back(page_point(view_, scene_.vertices[at]));
    }
    return at == to ? path : std::vector<Point2>{};
  }

  const Scene& scene_;
  const View& view_;
  const SmoothPatch& patch_;
  std::vector<ContourChain>& chains_;
  const std::vector<OutlineSide>& sides_;
};

}  // namespace

std::vector<OutlineSide> outline_sides(const Topology& topology, const SmoothPatch& patch,
                                       std::span<const std::uint32_t> outline_edges) {
  // Per vertex: index of the first edge that has it as its lower vertex.
  std::vector<std::uint32_t> begin;
  for (std::uint32_t i = 0; i < outline_edges.size(); ++i) {
    begin.resize(std::max<std::size_t>(begin.size(), topology.edges[outline_edges[i]].v0 + 1), i);
  }
  const auto edge_of = [&](std::uint32_t s) {
    if (patch.across[s] == kNone || patch.across[s] < s) return kNone;
    const auto& v = patch.triangles[s / 3].v;
    const std::uint32_t a = v[s % 3], b = v[(s + 1) % 3], low = std::min(a, b), high = std::max(a, b);
    if (low >= begin.size()) return kNone;
    const auto first = outline_edges.begin() + begin[low];
    const auto last = low + 1 < begin.size() ? outline_edges.begin() + begin[low + 1] : outline_edges.end();
    const auto e = std::partition_point(first, last, [&](std::uint32_t k) { return topology.edges[k].v1 < high; });
    return e != last && topology.edges[*e].v1 == high ? *e : kNone;
  };
  const auto is_outline = [&](std::size_t s) { return edge_of(static_cast<std::uint32_t>(s)) != kNone; };
  std::vector<OutlineSide> found;
  for (const std::uint32_t s : indices_where(patch.across.size(), is_outline)) found.push_back({edge_of(s), s});
  return found;
}

ContourChoice choose_contours(const Scene& scene, const View& view, const SmoothPatch& patch,
                              std::vector<ContourChain> chains, const std::vector<OutlineSide>& sides, double pen_width_mm) {
  ContourChoice choice;
  Chooser chooser(scene, view, patch, chains, sides);
  const std::vector<Group> groups = chooser.groups();
  std::vector<std::optional<std::vector<ContourChain>>> found(groups.size());
  parallel_for(groups.size(), [&](std::size_t i) { found[i] = chooser.replacement(groups[i], pen_width_mm); });
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (!found[i]) continue;
    std::ranges::move(*found[i], std::back_inserter(choice.chains));
    choice.sides.insert(choice.sides.end(), groups[i].sides.begin(), groups[i].sides.end());
  }
  std::sort(choice.sides.begin(), choice.sides.end());
  return choice;
}

}  // namespace ligne
