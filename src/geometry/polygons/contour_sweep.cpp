// A line sweeps over the positions in their order (from left to right, and upwards where x is equal). The edges that it
// crosses are kept in order from below to above (Shamos and Hoey 1976). Only signs are computed.
//
//          \      above        At a position p the bundles that end there or pass through it stand in a row in the order,
//      ----- p -----           since their line and p have orientation 0. They are taken out, and cut there. What goes on
//          /  \                from them and the edges that begin at p are sorted by direction and put in. Edges of one
//      below   ----            direction are one *bundle*: the nearest of their ends is the next place where it is cut.
//
// Invariants: up to the sweep line no two edges in the order have crossed, and no bundle holds a position in its
// inside; two neighbouring bundles do not cross further on, unless one of them ends before. So the edges of the first
// crossing are found as neighbours before the line reaches it. Both are then taken out, and cut at the positions that
// EdgeCutter finds on them.
//
// A bundle whose edges cancel out bounds nothing. While one is in the order no slab can be followed, so the pieces are
// swept again without it.

#include "geometry/polygons/contour_sweep.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/no_index.hpp"
#include "geometry/polygons/contour_edges.hpp"
#include "geometry/polygons/monotone_chains.hpp"
#include "geometry/polygons/sweep_order.hpp"
#include "geometry/predicates.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;
using Node = SweepOrder::Node;
using Slab = MonotoneChains::Slab;

/// Edge numbers by position: those of position i are list[begin[i]] to list[begin[i + 1] - 1], in ascending order.
struct EdgesOfPosition {
  std::vector<Index> begin, list;
  template <class End>
  EdgesOfPosition(std::size_t positions, const std::vector<SweepEdge>& edges, End end)
      : begin(positions + 1, 0), list(edges.size()) {
    for (const SweepEdge& e : edges) ++begin[end(e) + 1];
    for (std::size_t i = 0; i < positions; ++i) begin[i + 1] += begin[i];
    std::vector<Index> next(begin.begin(), begin.end() - 1);
    for (Index e = 0; e < edges.size(); ++e) list[next[end(edges[e])]++] = e;
  }
};

/// Merges edges between the same two positions; drops those that cancel out.
std::vector<SweepEdge> merge_equal(std::size_t positions, const std::vector<SweepEdge>& edges) {
  const EdgesOfPosition leaving(positions, edges, [](const SweepEdge& e) { return e.low; });
  std::vector<SweepEdge> merged;
  merged.reserve(edges.size());
  std::vector<SweepEdge> here;
  for (std::size_t i = 0; i < positions; ++i) {
    here.clear();
    for (Index k = leaving.begin[i]; k < leaving.begin[i + 1]; ++k) here.push_back(edges[leaving.list[k]]);
    std::sort(here.begin(), here.end(), [](const SweepEdge& a, const SweepEdge& b) { return a.high < b.high; });
    for (std::size_t k = 0; k < here.size();) {
      SweepEdge sum{here[k].low, here[k].high, 0};
      for (; k < here.size() && here[k].high == sum.high; ++k) sum.winding += here[k].winding;
      if (sum.winding != 0) merged.push_back(sum);
    }
  }
  return merged;
}

class ContourSweep {
 public:
  /// `edges` must come from merge_equal().
  ContourSweep(const std::vector<Point2>& positions, const std::vector<SweepEdge>& edges)
      : p_(positions),
        edges_(edges),
        arriving_(positions.size(), edges, [](const SweepEdge& e) { return e.high; }),
        heaps_(edges.size()),
        node_of_(edges.size(), kNone),
        chains_(positions) {
    pieces_.reserve(edges.size());
  }

  void run() {
    for (Index p = 0, next = 0; p < p_.size(); ++p) {
      const Index first = next;
      while (next < edges_.size() && edges_[next].low == p) ++next;
      visit(p, first, next);
    }
    if (crossed_.empty()) return;
    EdgeCutter cutter(p_);
    for (const SweepEdge& rest : crossed_) cutter.append_pieces(rest, pieces_);
  }

  bool crossing() const { return crossing_; }
  bool wound_once() const { return wound_once_; }
  bool cancelling() const { return cancelling_; }
  std::vector<SweepEdge>& pieces() { return pieces_; }
  std::vector<MonotoneChains::Triple>& triangles() { return chains_.triangles(); }

 private:
  /// Edges that coincide from `from` on, as a leftist heap (Crane 1972) whose root is an edge that ends first.
  struct Bundle {
    Point2 low, high;  ///< ends of the root
    Index root = kNone;
    Index from = 0;
    std::int32_t winding = 0;  ///< of all its edges
    std::int32_t above = 0;    ///< winding number of the contours about the region above
    Slab slab = 0;             ///< slab of the region above, if that is inside
  };
  struct Heap {
    Index left = kNone, right = kNone;
    Index rank = 1;
  };

  bool followed() const { return !crossing_ && wound_once_ && !cancelling_; }

  Index rank(Index e) const { return e == kNone ? 0 : heaps_[e].rank; }

  /// The recursion depth is at most the sum of both ranks: the logarithm of the number of edges.
  Index meld(Index a, Index b) {
    if (a == kNone) return b;
    if (b == kNone) return a;
    if (edges_[b].high < edges_[a].high) std::swap(a, b);
    heaps_[a].right = meld(heaps_[a].right, b);
    if (rank(heaps_[a].left) < rank(heaps_[a].right)) std::swap(heaps_[a].left, heaps_[a].right);
    heaps_[a].rank = rank(heaps_[a].right) + 1;
    return a;
  }

  int side(Node n, Index p) const { return orientation_sign(bundles_[n].low, bundles_[n].high, p_[p]); }

  /// Fills touched_ with the bundles through p. Returns the bundle below p and the one above.
  std::pair<Node, Node> find_touched(Index p) {
    touched_.clear();
    Node first = kNone;
    for (Index k = arriving_.begin[p]; k < arriving_.begin[p + 1] && first == kNone; ++k) {
      first = node_of_[arriving_.list[k]];
    }
    Node below = kNone, above = kNone;
    if (first != kNone) {
      while (order_.previous(first) != kNone && side(order_.previous(first), p) == 0) first = order_.previous(first);
      below = order_.previous(first);
      above = first;
    } else {
      above = order_.find_first([&](Node n) { return side(n, p) <= 0; });
      below = above == kNone ? last_node() : order_.previous(above);
      if (above != kNone && side(above, p) != 0) return {below, above};
    }
    while (above != kNone && (above == first || side(above, p) == 0)) {
      touched_.push_back(above);
      above = order_.next(above);
    }
    return {below, above};
  }

  Node last_node() const {
    Node last = kNone;
    order_.find_first([&](Node n) {
      last = n;
      return false;
    });
    return last;
  }

  /// Fills leaving_ with the bundles that continue from p, from below to above.
  void find_leaving(Index p, Index first, Index last) {
    leaving_.clear();
    for (const Node n : touched_) {
      Bundle b = bundles_[n];
      add_piece({b.from, p, b.winding});
      while (b.root != kNone && edges_[b.root].high == p) {
        b.winding -= edges_[b.root].winding;
        node_of_[b.root] = kNone;
        b.root = meld(heaps_[b.root].left, heaps_[b.root].right);
      }
      if (b.root == kNone) continue;
      b.from = p;
      leaving_.push_back(b);
    }
    for (Index e = first; e < last; ++e) leaving_.push_back({{}, {}, e, p, edges_[e].winding, 0, 0});
    if (leaving_.size() < 2) return;
    const auto turn = [&](const Bundle& a, const Bundle& b) {
      return orientation_sign(p_[p], p_[edges_[a.root].high], p_[edges_[b.root].high]);
    };
    std::sort(leaving_.begin(), leaving_.end(), [&](const Bundle& a, const Bundle& b) { return turn(a, b) > 0; });
    std::size_t kept = 0;
    for (std::size_t i = 1; i < leaving_.size(); ++i) {
      if (turn(leaving_[kept], leaving_[i]) == 0) {
        node_of_[leaving_[kept].root] = node_of_[leaving_[i].root] = kNone;
        leaving_[kept].root = meld(leaving_[kept].root, leaving_[i].root);
        leaving_[kept].winding += leaving_[i].winding;
      } else {
        leaving_[++kept] = leaving_[i];
      }
    }
    leaving_.resize(kept + 1);
  }

  void add_piece(const SweepEdge& piece) {
    if (piece.winding != 0) pieces_.push_back(piece);
  }

  void visit(Index p, Index first, Index last) {
    const auto [below, above] = find_touched(p);
    find_leaving(p, first, last);
    std::int32_t winding = below == kNone ? 0 : bundles_[below].above;
    for (Bundle& b : leaving_) {
      winding += b.winding;
      b.above = winding;
      if (b.winding == 0) cancelling_ = true;
      if (winding < 0 || winding > 1) wound_once_ = false;
    }
    if (followed()) cut_slabs(p, below);
    const auto [lowest, highest] = put_in_order(below);
    if (lowest == kNone) {
      check_neighbours(below, above);
    } else {
      check_neighbours(highest, above);
      // Taking out may have removed all new bundles; it has then checked the neighbours below.
      if (bundles_[lowest].root != kNone) check_neighbours(below, lowest);
    }
  }

  /// Puts the bundles of leaving_ in the place of those of touched_. Returns the lowest and the highest of them.
  std::pair<Node, Node> put_in_order(Node below) {
    Node lowest = kNone, at = below;
    for (std::size_t i = 0; i < leaving_.size(); ++i) {
      at = i < touched_.size() ? touched_[i] : order_.insert_after(at);
      if (at == bundles_.size()) bundles_.emplace_back();
      const SweepEdge& root = edges_[leaving_[i].root];
      leaving_[i].low = p_[root.low];
      leaving_[i].high = p_[root.high];
      bundles_[at] = leaving_[i];
      node_of_[leaving_[i].root] = at;
      if (i == 0) lowest = at;
    }
    for (std::size_t i = leaving_.size(); i < touched_.size(); ++i) order_.erase(touched_[i]);
    return {lowest, lowest == kNone ? kNone : at};
  }

  /// Updates the slabs around p, if everything so far is simple.
  void cut_slabs(Index p, Node below) {
    const auto inside_above = [&](Node n) { return n != kNone && bundles_[n].above == 1; };
    for (std::size_t i = 0; i + 1 < touched_.size(); ++i) {
      if (inside_above(touched_[i])) chains_.end(bundles_[touched_[i]].slab, p);
    }
    const Slab lower = below == kNone ? 0 : bundles_[below].slab;
    Slab upper = touched_.empty() ? lower : bundles_[touched_.back()].slab;
    const bool under = inside_above(below), over = touched_.empty() ? under : inside_above(touched_.back());
    if (touched_.empty()) {
      if (under && !leaving_.empty()) upper = chains_.split(lower, p);
    } else if (leaving_.empty()) {
      assert(under == over);
      if (under) chains_.merge(lower, upper, p);
    } else {
      if (under) chains_.add_upper(lower, p);
      if (over) chains_.add_lower(upper, p);
    }
    for (std::size_t i = 0; i + 1 < leaving_.size(); ++i) {
      if (leaving_[i].above == 1) leaving_[i].slab = chains_.start(p);
    }
    if (!leaving_.empty()) leaving_.back().slab = upper;
  }

  /// Whether two neighbours cross further on: the end of the bundle that ends first lies on the wrong side of the
  /// other.
  bool cross(Node below, Node above) const {
    const Bundle &a = bundles_[below], &b = bundles_[above];
    if (edges_[a.root].high <= edges_[b.root].high) return orientation_sign(b.low, b.high, a.high) > 0;
    return orientation_sign(a.low, a.high, b.high) < 0;
  }

  /// Takes out neighbours that cross, then the new neighbours that cross, until none do.
  void check_neighbours(Node below, Node above) {
    while (below != kNone && above != kNone && cross(below, above)) {
      crossing_ = true;
      const Node lower = order_.previous(below), upper = order_.next(above);
      take_out(below);
      take_out(above);
      below = lower;
      above = upper;
    }
  }

  /// Takes out a bundle. Its edges are cut when the sweep is done.
  void take_out(Node n) {
    std::vector<Index> rest{bundles_[n].root};
    node_of_[rest.back()] = kNone;
    while (!rest.empty()) {
      const Index e = rest.back();
      rest.pop_back();
      if (e == kNone) continue;
      crossed_.push_back({bundles_[n].from, edges_[e].high, edges_[e].winding});
      rest.push_back(heaps_[e].left);
      rest.push_back(heaps_[e].right);
    }
    bundles_[n].root = kNone;
    order_.erase(n);
  }

  const std::vector<Point2>& p_;
  const std::vector<SweepEdge>& edges_;
  EdgesOfPosition arriving_;
  std::vector<Heap> heaps_;    ///< by edge
  std::vector<Node> node_of_;  ///< by edge: the bundle that has it as root
  SweepOrder order_;
  std::vector<Bundle> bundles_;     ///< by node
  std::vector<Node> touched_;       ///< scratch
  std::vector<Bundle> leaving_;     ///< scratch
  std::vector<SweepEdge> crossed_;  ///< remainders of the edges taken out
  std::vector<SweepEdge> pieces_;
  MonotoneChains chains_;
  bool crossing_ = false, wound_once_ = true, cancelling_ = false;
};

}  // namespace

SweptContours sweep_contours(const std::vector<Point2>& positions, std::vector<SweepEdge> edges) {
  SweptContours swept;
  for ([[maybe_unused]] bool first = true;; first = false) {
    edges = merge_equal(positions.size(), edges);
    ContourSweep sweep(positions, edges);
    sweep.run();
    swept.simple = !sweep.crossing() && sweep.wound_once();
    swept.pieces = std::move(sweep.pieces());
    if (swept.simple) swept.triangles = std::move(sweep.triangles());
    if (!swept.simple || !sweep.cancelling()) return swept;
    assert(first);  // the pieces neither touch nor cancel out
    edges = swept.pieces;
  }
}

}  // namespace ligne
