#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "linework/map/line_groups.hpp"
#include "linework/rules/rules.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Extends a bounding box on the lattice.
void extend(Rect& box, const Stroke& s) {
  for (const LatticePoint p : {s.from, s.to}) box.extend({p.x, p.y});
}

/// Clusters of chains that may be removed, and the lines that keep them.
class IsolatedChains {
 public:
  IsolatedChains(LineMap& map, const BodyOf& body_of, const IsolatedLimits& limits)
      : map_(map), chains_(map), limits_(limits), may_go_(map.piece_count(), 1), clusters_(map.piece_count()) {
    find_candidates(body_of);
    held_.assign(map.piece_count(), 0);
    ends_held_.assign(map.piece_count(), 0);
    for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
      if (is_candidate(p)) meet_others(p);
    }
  }

  std::size_t remove() {
    // The three lists are by cluster.
    std::vector<Rect> extents(map_.piece_count());
    std::vector<std::uint8_t> held(map_.piece_count(), 0);
    std::vector<std::uint32_t> ends_held(map_.piece_count(), 0);
    for (std::uint32_t p = 0; p < map_.piece_count(); ++p) {
      if (!is_candidate(p)) continue;
      const std::uint32_t cluster = clusters_.find(chains_.of(p));
      extend(extents[cluster], map_.piece(p));
      held[cluster] |= held_[p];
      ends_held[cluster] += ends_held_[p];
    }
    std::size_t removed = 0;
    for (std::uint32_t p = 0; p < map_.piece_count(); ++p) {
      if (!is_candidate(p)) continue;
      const std::uint32_t cluster = clusters_.find(chains_.of(p));
      const Rect& box = extents[cluster];
      const bool is_small = std::max(box.width(), box.height()) <= limits_.longest_mm / map_.step_mm();
      if (held[cluster] || ends_held[cluster] > limits_.most_ends_on_lines || !is_small) continue;
      removed += chains_.of(p) == p;
      map_.remove(p);
    }
    return removed;
  }

 private:
  bool is_candidate(std::uint32_t p) const { return chains_.of(p) != kNone && may_go_[chains_.of(p)]; }

  void find_candidates(const BodyOf& body_of) {
    const std::vector<double> extents = body_extents(map_, body_of);
    std::vector<std::uint32_t> body(map_.piece_count(), kNone);  // by chain
    for (std::uint32_t p = 0; p < map_.piece_count(); ++p) {
      if (!map_.is_alive(p)) continue;
      const std::uint32_t b = body_of(map_.piece(p)), chain = chains_.of(p);
      body[chain] = b;
      if (b == kNone || !limits_.classes.has(map_.piece(p).line_class)) may_go_[chain] = 0;
    }
    std::vector<std::uint32_t> rings;
    for (std::uint32_t p = 0; p < map_.piece_count(); ++p) {
      if (chains_.of(p) != p || !may_go_[p]) continue;
      const double longest = std::min(limits_.longest_mm / map_.step_mm(), limits_.body_part * extents[body[p]]);
      may_go_[p] = chains_[p].free_ends == 2 && chains_[p].length <= longest;
      if (chains_[p].free_ends == 0 && chains_[p].length <= 2 * longest) rings.push_back(p);
    }
    keep_thin_rings(rings);
  }

  /// Marks rings that are narrow enough to be a line there and back: these may be removed too.
  void keep_thin_rings(const std::vector<std::uint32_t>& rings) {
    if (rings.empty()) return;
    std::vector<std::pair<std::uint32_t, LatticePoint>> corners;  // chain, point
    for (std::uint32_t p = 0; p < map_.piece_count(); ++p) {
      const std::uint32_t chain = chains_.of(p);
      if (chain == kNone || !std::ranges::binary_search(rings, chain)) continue;
      corners.emplace_back(chain, map_.piece(p).from);
      corners.emplace_back(chain, map_.piece(p).to);
    }
    std::ranges::sort(corners);
    using Corner = std::pair<std::uint32_t, LatticePoint>;
    for (const std::uint32_t ring : rings) {
      const auto first = std::ranges::lower_bound(corners, ring, {}, &Corner::first);
      const std::span<const Corner> own(first, std::ranges::upper_bound(first, corners.end(), ring, {}, &Corner::first));
      Stroke axis;  // to the corner farthest from the first one
      axis.from = axis.to = own.front().second;
      for (const auto& [chain, p] : own) {
        if (length(axis.from, p) > page_length(axis)) axis.to = p;
      }
      may_go_[ring] = std::ranges::all_of(own, [&](const Corner& corner) {
        return foot_on(axis, corner.second).distance <= limits_.ring_width_mm / map_.step_mm();
      });
    }
  }

  /// Finds the lines that end on a piece of a candidate, and those on which the piece ends.
  void meet_others(std::uint32_t p) {
    const double reach = limits_.touching_mm / map_.step_mm();
    const Stroke& s = map_.piece(p);
    const std::uint32_t chain = chains_.of(p);
    const bool is_ring = chains_[chain].free_ends == 0;
    const std::uint32_t ends[2] = {2 * p, 2 * p + 1};
    bool on_line[2] = {false, false};
    map_.near(s.from, s.to, reach, [&](std::uint32_t other) {
      const std::uint32_t other_chain = chains_.of(other);
      if (other_chain == chain) return false;
      for (const int k : {0, 1}) {
        if (!is_ring && !map_.is_free(ends[k])) continue;
        if (foot_on(map_.piece(other), map_.point(ends[k])).distance > reach) continue;
        if (may_go_[other_chain]) {
          clusters_.join(chain, other_chain);
        } else {
          on_line[k] = true;
        }
      }
      for (const std::uint32_t end : {2 * other, 2 * other + 1}) {
        if (may_go_[other_chain] || !map_.is_free(end)) continue;
        if (foot_on(s, map_.point(end)).distance <= reach) held_[p] = 1;
      }
      return false;
    });
    ends_held_[p] = static_cast<std::uint32_t>(on_line[0] + on_line[1]);
  }

  LineMap& map_;
  Chains chains_;
  IsolatedLimits limits_;
  std::vector<std::uint8_t> may_go_;      ///< by chain
  DisjointSets clusters_;                 ///< sets of chains
  std::vector<std::uint8_t> held_;        ///< by piece: a line ends on it
  std::vector<std::uint32_t> ends_held_;  ///< by piece: its ends that lie on lines
};

}  // namespace

std::vector<double> body_extents(const LineMap& map, const BodyOf& body_of) {
  std::vector<Rect> extents;
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    if (!map.is_alive(p)) continue;
    const std::uint32_t body = body_of(map.piece(p));
    if (body == kNone) continue;
    if (body >= extents.size()) extents.resize(body + 1);
    extend(extents[body], map.piece(p));
  }
  std::vector<double> diagonals;
  diagonals.reserve(extents.size());
  for (const Rect& box : extents) diagonals.push_back(std::hypot(box.width(), box.height()));
  return diagonals;
}

std::size_t remove_isolated_chains(LineMap& map, const BodyOf& body_of, const IsolatedLimits& limits) {
  return IsolatedChains(map, body_of, limits).remove();
}

}  // namespace ligne
