#include "drawing/cleanup/flecks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "drawing/graphs/stroke_chains.hpp"
#include "drawing/overlaps/stroke_index.hpp"

namespace ligne {
namespace {

/// The extent of strokes on the lattice.
struct Extent {
  double low_x = std::numeric_limits<double>::max(), low_y = low_x, high_x = -low_x, high_y = -low_x;

  void add(LatticePoint p) {
    low_x = std::min<double>(low_x, p.x);
    low_y = std::min<double>(low_y, p.y);
    high_x = std::max<double>(high_x, p.x);
    high_y = std::max<double>(high_y, p.y);
  }
  double side() const { return std::max(high_x - low_x, high_y - low_y); }
  double diagonal() const { return std::hypot(high_x - low_x, high_y - low_y); }
};

double distance(LatticePoint p, const Stroke& s) {
  const double dx = double(s.to.x) - s.from.x, dy = double(s.to.y) - s.from.y;
  const double px = double(p.x) - s.from.x, py = double(p.y) - s.from.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(px - t * dx, py - t * dy);
}

/// Things in cells of a grid; a thing may lie in many.
class Cells {
 public:
  void add(std::uint64_t cell, std::uint32_t thing) {
    std::uint32_t& first = table_[cell];
    links_.push_back({thing, first});
    first = static_cast<std::uint32_t>(links_.size() - 1);
  }
  template <class Visit>
  void visit(std::uint64_t cell, const Visit& visit) const {
    for (std::uint32_t l = table_.find(cell); l != kNone; l = links_[l].next) visit(links_[l].thing);
  }

 private:
  struct Link {
    std::uint32_t thing, next;
  };
  KeyTable table_;
  std::vector<Link> links_;
};

/// Finds the ends at, or beside, the chains that may be flecks.
class FleckFinder {
 public:
  FleckFinder(const std::vector<Stroke>& strokes, const StrokeChains& chains, std::vector<std::uint8_t> may_be,
              double touching)
      : strokes_(strokes),
        chains_(chains),
        may_be_(std::move(may_be)),
        touching_(touching),
        grid_(walked_cell(strokes, 2 * touching), touching),
        clusters_(strokes.size()),
        held_(strokes.size(), 0),
        ends_held_(strokes.size(), 0) {
    for (const std::uint32_t i : chains_.seen()) {
      if (!may_be_[chains_.chain_of(i)]) continue;
      const Stroke& s = strokes_[i];
      along(s.from, s.to, [&](std::uint64_t cell) { fleck_strokes_.add(cell, i); });
      const bool in_ring = chains_.chain(chains_.chain_of(i)).free_ends == 0;
      for (const bool at_from : {true, false}) {
        if (!in_ring && !chains_.is_free(i, at_from)) continue;
        const LatticePoint end = at_from ? s.from : s.to;
        fleck_ends_.add(grid_.cell_of(end), static_cast<std::uint32_t>(ends_.size()));
        ends_.push_back({end, chains_.chain_of(i)});
      }
    }
    for (const std::uint32_t i : chains_.seen()) meet(i);
  }

  /// By chain; only where it may be one.
  std::vector<std::uint8_t> flecks(double longest, std::uint32_t most_ends_on_lines) {
    std::vector<Extent> extents(strokes_.size());
    std::vector<std::uint8_t> held(strokes_.size(), 0);
    std::vector<std::uint32_t> ends_held(strokes_.size(), 0);
    for (const std::uint32_t i : chains_.seen()) {
      const std::uint32_t chain = chains_.chain_of(i);
      if (!may_be_[chain]) continue;
      const std::uint32_t cluster = clusters_.find(chain);
      extents[cluster].add(strokes_[i].from);
      extents[cluster].add(strokes_[i].to);
      if (chain != i) continue;
      held[cluster] |= held_[i];
      ends_held[cluster] += ends_held_[i];
    }
    std::vector<std::uint8_t> found(strokes_.size(), 0);
    for (const std::uint32_t i : chains_.seen()) {
      if (chains_.chain_of(i) != i || !may_be_[i]) continue;
      const std::uint32_t cluster = clusters_.find(i);
      found[i] = !held[cluster] && ends_held[cluster] <= most_ends_on_lines && extents[cluster].side() <= longest;
    }
    return found;
  }

 private:
  struct End {
    LatticePoint at;
    std::uint32_t chain;
    bool held = false;
  };

  template <class Visit>
  void along(LatticePoint from, LatticePoint to, const Visit& visit) const {
    grid_.walk(from, to, [&](std::uint64_t cell) {
      visit(cell);
      return false;
    });
  }

  void meet(std::uint32_t i) {
    const Stroke& s = strokes_[i];
    const std::uint32_t chain = chains_.chain_of(i);
    along(s.from, s.to, [&](std::uint64_t cell) {
      fleck_ends_.visit(cell, [&](std::uint32_t e) {
        End& end = ends_[e];
        if (end.held || end.chain == chain || distance(end.at, s) > touching_) return;
        if (may_be_[chain]) {
          clusters_.join(chain, end.chain);
        } else {
          end.held = true;
          ++ends_held_[end.chain];
        }
      });
    });
    for (const bool at_from : {true, false}) {
      if (may_be_[chain] || !chains_.is_free(i, at_from)) continue;
      const LatticePoint end = at_from ? s.from : s.to;
      fleck_strokes_.visit(grid_.cell_of(end), [&](std::uint32_t f) {
        if (distance(end, strokes_[f]) <= touching_) held_[chains_.chain_of(f)] = 1;
      });
    }
  }

  const std::vector<Stroke>& strokes_;
  const StrokeChains& chains_;
  std::vector<std::uint8_t> may_be_;  ///< by chain, as all of the following
  double touching_;
  SegmentGrid grid_;
  DisjointSets clusters_;
  std::vector<std::uint8_t> held_;       ///< a line ends on it
  std::vector<std::uint8_t> ends_held_;  ///< of its ends, those that lie on lines
  std::vector<End> ends_;
  Cells fleck_strokes_, fleck_ends_;
};

/// Takes out of `rings`, chains without free ends in order, those that are wider than a line.
void leave_thin(std::vector<std::uint32_t>& rings, const std::vector<Stroke>& strokes, const StrokeChains& chains,
                double width) {
  std::vector<std::pair<std::uint32_t, LatticePoint>> ends;
  for (const std::uint32_t i : chains.seen()) {
    const std::uint32_t chain = chains.chain_of(i);
    if (!std::ranges::binary_search(rings, chain)) continue;
    ends.emplace_back(chain, strokes[i].from);
    ends.emplace_back(chain, strokes[i].to);
  }
  std::ranges::sort(ends);
  std::erase_if(rings, [&](std::uint32_t ring) {
    using End = std::pair<std::uint32_t, LatticePoint>;
    const auto first = std::ranges::lower_bound(ends, ring, {}, &End::first);
    const std::span<const End> own(first, std::ranges::upper_bound(first, ends.end(), ring, {}, &End::first));
    Stroke axis;
    axis.from = axis.to = own.front().second;
    for (const auto& [chain, p] : own) {
      Stroke longer = axis;
      longer.to = p;
      if (page_length(longer) > page_length(axis)) axis = longer;
    }
    return std::ranges::any_of(own, [&](const auto& end) { return distance(end.second, axis) > width; });
  });
}

}  // namespace

std::vector<double> body_extents(const std::vector<Stroke>& strokes,
                                 const std::function<std::uint32_t(const Stroke&)>& body_of) {
  std::vector<Extent> extents;
  for (const Stroke& s : strokes) {
    if (!is_seen(s)) continue;
    const std::uint32_t body = body_of(s);
    if (body == kNone) continue;
    if (body >= extents.size()) extents.resize(body + 1);
    extents[body].add(s.from);
    extents[body].add(s.to);
  }
  std::vector<double> diagonals;
  diagonals.reserve(extents.size());
  for (const Extent& extent : extents) diagonals.push_back(extent.diagonal());
  return diagonals;
}

std::size_t drop_flecks(StrokeModel& model, const std::function<std::uint32_t(const Stroke&)>& body_of,
                        const FleckLimits& limits) {
  std::vector<Stroke>& strokes = model.strokes;
  const double step = model.lattice.step_mm;
  const StrokeChains chains(strokes);
  const std::vector<double> extents = body_extents(strokes, body_of);
  if (extents.empty()) return 0;
  std::vector<std::uint32_t> body(strokes.size(), kNone);  // by chain
  std::vector<std::uint8_t> may_be(strokes.size(), 1);     // by chain
  for (const std::uint32_t i : chains.seen()) {
    const std::uint32_t b = body_of(strokes[i]), chain = chains.chain_of(i);
    body[chain] = b;
    if (b == kNone || !limits.classes.has(strokes[i].line_class)) may_be[chain] = 0;
  }
  bool any = false;
  std::vector<std::uint32_t> rings;
  for (const std::uint32_t i : chains.seen()) {
    if (chains.chain_of(i) != i || !may_be[i]) continue;
    const StrokeChains::Chain& chain = chains.chain(i);
    const double longest = std::min(limits.longest_mm / step, limits.body_part * extents[body[i]]);
    may_be[i] = chain.free_ends == 2 && chain.length <= longest;
    any |= may_be[i];
    if (chain.free_ends == 0 && chain.length <= 2 * longest) rings.push_back(i);
  }
  if (!rings.empty()) leave_thin(rings, strokes, chains, limits.ring_width_mm / step);
  for (const std::uint32_t ring : rings) may_be[ring] = 1;
  any |= !rings.empty();
  if (!any) return 0;
  FleckFinder finder(strokes, chains, std::move(may_be), limits.touching_mm / step);
  const std::vector<std::uint8_t> flecks = finder.flecks(limits.longest_mm / step, limits.most_ends_on_lines);
  return leave_out(strokes, chains, [&](std::uint32_t chain) { return flecks[chain] != 0; });
}

}  // namespace ligne
