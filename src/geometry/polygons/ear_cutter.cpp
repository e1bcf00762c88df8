// The loops share no edges (contour_links.hpp); a hole that touches the outer contour is part of it. Other holes are
// joined by bridges, in the order of their leftmost corners, so that only parts already joined can block a bridge. Then
// ears are cut:
//
//            c                An ear is a convex corner b whose triangle a b c holds nothing of the rest of the ring in its
//           / \               inside. Rings touch themselves (at bridges, and where a diagonal passes a corner), so a corner
//      ----'   \     ,---     on the triangle's border blocks it only when one of its edges runs into the triangle.
//               \   /
//                `-'  reflex corner: only these can block.
//
// Every triangle cut is convex and every cut takes a corner away, so the areas add up to the polygon's and the loop ends.

#include "geometry/polygons/ear_cutter.hpp"

#include <algorithm>
#include <utility>

#include "base/no_index.hpp"
#include "base/stop.hpp"
#include "geometry/predicates.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;
using Triple = std::array<Index, 3>;

/// Largest number of corners tested: the first number, or the second per corner of the loops if that is more. Loops
/// that do not cross need far fewer. Without a bound the work on a scribble would grow with the square of its corners.
/// Adjustable: a few tenths of a second.
constexpr std::size_t kLooksAtLeast = std::size_t{1} << 24, kLooksOfCorner = 512;
/// Number of corners tested between two calls of check_stop().
constexpr std::size_t kTestsPerStopCheck = std::size_t{1} << 16;

/// A corner of a ring, which is a cyclic list with the inside on its left.
struct CornerNode {
  Index position = 0;
  Index prev = 0, next = 0;
  bool cut = false;
  bool reflex = false;  ///< in the list of corners that can block
  /// A node found inside the triangle at this corner, and the triangle's other corners at that time.
  Index blocker = kNone, blocked_prev = kNone, blocked_next = kNone;
};

class EarCutter {
 public:
  EarCutter(const std::vector<Point2>& positions, const LinkedContours& links) : p_(positions) {
    for (const auto& loop : links.outer) rings_.push_back(add_ring(loop));
    std::vector<Index> holes;
    const auto outer_nodes = static_cast<Index>(nodes_.size());
    for (const auto& loop : links.holes) {
      const Index first = add_ring(loop);
      holes.push_back(first + static_cast<Index>(std::ranges::min_element(loop) - loop.begin()));
    }
    // Positions are numbered from left to right, then from below.
    std::ranges::sort(holes, [&](Index a, Index b) { return nodes_[a].position < nodes_[b].position; });
    looks_left_ = std::max(kLooksAtLeast, kLooksOfCorner * nodes_.size());
    for (Index n = 0; n < outer_nodes; ++n) joined_.push_back(n);
    for (const Index hole : holes) join_hole(hole);
  }

  /// Triangles as triples of positions.
  std::vector<Triple> cut() {
    for (const Index ring : rings_) cut_ring(ring);
    return std::move(triangles_);
  }

  /// Whether everything was cut.
  bool whole() const { return whole_; }

 private:
  /// Counts tested corners; false if the bound is exceeded.
  bool may_look(std::size_t corners) {
    const std::size_t before = looks_left_ / kTestsPerStopCheck;
    looks_left_ -= std::min(looks_left_, corners);
    if (looks_left_ / kTestsPerStopCheck != before) check_stop();
    return looks_left_ > 0;
  }

  Point2 at(Index node) const { return p_[nodes_[node].position]; }
  int turn(Index node) const { return orientation_sign(at(nodes_[node].prev), at(node), at(nodes_[node].next)); }

  Index add_ring(const std::vector<Index>& loop) {
    const auto first = static_cast<Index>(nodes_.size());
    const auto n = static_cast<Index>(loop.size());
    for (Index i = 0; i < n; ++i) nodes_.push_back({loop[i], first + (i + n - 1) % n, first + (i + 1) % n});
    return first;
  }

  /// True when the segment from node v to the point m begins inside the sector that the ring leaves free at v.
  bool in_sector(Index v, Point2 m) const {
    const Point2 a = at(nodes_[v].prev), b = at(v), c = at(nodes_[v].next);
    const int left_of_in = orientation_sign(a, b, m), left_of_out = orientation_sign(b, c, m);
    if (orientation_sign(a, b, c) > 0) return left_of_in > 0 && left_of_out > 0;
    return left_of_in > 0 || left_of_out > 0;
  }

  /// True when the open segment between nodes m and v meets the joined rings. v is lower in number than m.
  bool blocked(Index m, Index v) const {
    const Point2 pm = at(m), pv = at(v);
    const double y_min = std::min(pm.y, pv.y), y_max = std::max(pm.y, pv.y);
    for (const Index n : joined_) {
      const Point2 a = at(n), b = at(nodes_[n].next);
      if (std::max(a.x, b.x) < pv.x || std::min(a.x, b.x) > pm.x) continue;
      if (std::max(a.y, b.y) < y_min || std::min(a.y, b.y) > y_max) continue;
      const int side_a = orientation_sign(pv, pm, a);
      if (side_a == 0 && nodes_[n].position > nodes_[v].position && nodes_[n].position < nodes_[m].position) return true;
      if (side_a * orientation_sign(pv, pm, b) < 0 && orientation_sign(a, b, pv) * orientation_sign(a, b, pm) < 0) {
        return true;
      }
    }
    return false;
  }

  /// Joins the ring of a hole by a bridge from its first corner m (lowest number) to the nearest visible corner of
  /// lower number. There is one if the contours do not cross; a hole outside every contour stays out.
  void join_hole(Index m) {
    const auto distance = [&](Index n) {
      const Point2 d = at(n) - at(m);
      return d.x * d.x + d.y * d.y;
    };
    if (!may_look(joined_.size())) {
      whole_ = false;
      return;
    }
    std::vector<std::pair<double, Index>> near;
    for (const Index n : joined_) {
      if (nodes_[n].position < nodes_[m].position) near.emplace_back(distance(n), n);
    }
    const auto farther = [](const auto& a, const auto& b) { return a > b; };
    std::make_heap(near.begin(), near.end(), farther);
    while (!near.empty() && may_look(joined_.size())) {
      std::pop_heap(near.begin(), near.end(), farther);
      const Index v = near.back().second;
      near.pop_back();
      if (!in_sector(v, at(m)) || blocked(m, v)) continue;
      add_bridge(m, v);
      return;
    }
    whole_ = false;
  }

  /// Turns v -> w into v -> m -> (hole) -> m' -> v' -> w.
  void add_bridge(Index m, Index v) {
    for (Index n = m;;) {
      joined_.push_back(n);
      n = nodes_[n].next;
      if (n == m) break;
    }
    const Index w = nodes_[v].next, last = nodes_[m].prev;
    const auto m2 = static_cast<Index>(nodes_.size());
    const Index v2 = m2 + 1;
    nodes_.push_back({nodes_[m].position, last, v2});
    nodes_.push_back({nodes_[v].position, m2, w});
    nodes_[v].next = m;
    nodes_[m].prev = v;
    nodes_[last].next = m2;
    nodes_[w].prev = v2;
    joined_.push_back(m2);
    joined_.push_back(v2);
  }

  // --- ears -----------------------------------------------------------------------------------------------------------

  enum class Rule { strict, touching, any };

  /// True when the segment from `from`, a point of the closed triangle with the given sides, to `to` enters the
  /// triangle's inside.
  static bool enters(const Point2 (&t)[3], const int (&side)[3], Point2 to) {
    for (int i = 0; i < 3; ++i) {
      if (side[i] == 0 && orientation_sign(t[i], t[(i + 1) % 3], to) <= 0) return false;
    }
    return true;
  }

  /// True when corner n keeps the triangle t, cut off along t[2] t[0], from being an ear. Under the strict rule a
  /// corner in the middle of that diagonal blocks too, which postpones triangles with corners in the middle of their
  /// sides.
  bool blocks(Index n, const Point2 (&t)[3], Rule rule) const {
    const Point2 q = at(n);
    int side[3];
    for (int i = 0; i < 3; ++i) {
      side[i] = orientation_sign(t[i], t[(i + 1) % 3], q);
      if (side[i] < 0) return false;
    }
    if (side[0] > 0 && side[1] > 0 && side[2] > 0) return true;
    if (rule == Rule::strict && side[2] == 0 && side[0] > 0 && side[1] > 0) return true;
    return enters(t, side, at(nodes_[n].prev)) || enters(t, side, at(nodes_[n].next));
  }

  bool is_ear(Index b, Rule rule) {
    const Index a = nodes_[b].prev, c = nodes_[b].next;
    const Point2 t[3] = {at(a), at(b), at(c)};
    const int sign = orientation_sign(t[0], t[1], t[2]);
    if (sign < 0) return false;
    if (sign == 0) return rule != Rule::strict || t[0] == t[1] || t[1] == t[2];
    if (rule == Rule::any) return true;
    if (still_blocked(b)) return false;
    const Index n = find_blocker(b, t, rule);
    if (n == kNone) return true;
    if (inside(t, at(n))) {
      nodes_[b].blocker = n;
      nodes_[b].blocked_prev = a;
      nodes_[b].blocked_next = c;
    }
    return false;
  }

  /// Finds a corner that keeps the triangle t at b from being an ear.
  Index find_blocker(Index b, const Point2 (&t)[3], Rule rule) {
    const Index a = nodes_[b].prev, c = nodes_[b].next;
    const auto [y_min, y_max] = std::minmax({t[0].y, t[1].y, t[2].y});
    // A triangle's points have numbers between those of its corners.
    const auto [low, high] = std::minmax({nodes_[a].position, nodes_[b].position, nodes_[c].position});
    const auto before = [&](Index n, Index position) { return nodes_[n].position < position; };
    const auto begin = std::lower_bound(reflex_.begin(), reflex_.end(), low, before);
    auto it = begin;
    Index found = kNone;
    for (; found == kNone && it != reflex_.end() && nodes_[*it].position <= high; ++it) {
      const Index n = *it;
      const Point2 q = at(n);
      if (q.y < y_min || q.y > y_max) continue;
      if (n == a || n == b || n == c || nodes_[n].cut) continue;
      if (blocks(n, t, rule)) found = n;
    }
    may_look(static_cast<std::size_t>(it - begin));
    return found;
  }

  static bool inside(const Point2 (&t)[3], Point2 q) {
    return orientation_sign(t[0], t[1], q) > 0 && orientation_sign(t[1], t[2], q) > 0 && orientation_sign(t[2], t[0], q) > 0;
  }

  /// Whether the node that was found inside the triangle at b is still there. If contours cross, most corners stay
  /// blocked for good, and are tested again and again.
  bool still_blocked(Index b) const {
    const CornerNode& node = nodes_[b];
    return node.blocker != kNone && node.prev == node.blocked_prev && node.next == node.blocked_next &&
           !nodes_[node.blocker].cut && nodes_[node.blocker].reflex;
  }

  void cut_corner(Index b) {
    const Index a = nodes_[b].prev, c = nodes_[b].next;
    if (turn(b) > 0) triangles_.push_back({nodes_[a].position, nodes_[b].position, nodes_[c].position});
    nodes_[a].next = c;
    nodes_[c].prev = a;
    nodes_[b].cut = true;
  }

  /// Keeps in reflex_ the corners that can still block: those that are not strictly convex.
  void refresh_reflex() {
    std::erase_if(reflex_, [&](Index n) {
      const bool harmless = nodes_[n].cut || turn(n) > 0;
      if (harmless) nodes_[n].reflex = false;
      return harmless;
    });
  }

  void cut_ring(Index start) {
    reflex_.clear();
    std::size_t left = 0;
    for (Index n = start; left == 0 || n != start; n = nodes_[n].next, ++left) {
      nodes_[n].reflex = turn(n) <= 0;
      if (nodes_[n].reflex) reflex_.push_back(n);
    }
    std::ranges::stable_sort(reflex_, [&](Index m, Index n) { return nodes_[m].position < nodes_[n].position; });
    Index b = start;
    std::size_t failures = 0, cuts_since_refresh = 0;
    Rule rule = Rule::strict;
    while (left >= 3) {
      if (!may_look(1)) {
        whole_ = false;
        return;
      }
      const Index next = nodes_[b].next;
      if (is_ear(b, rule)) {
        cut_corner(b);
        --left;
        failures = 0;
        rule = Rule::strict;
        if (++cuts_since_refresh * 8 > reflex_.size()) {
          refresh_reflex();
          cuts_since_refresh = 0;
        }
        b = nodes_[next].next;  // skipping one corner gives fewer slender triangles
      } else if (++failures <= left) {
        b = next;
      } else {
        if (rule == Rule::any) {  // only reflex corners are left: contours that cross
          whole_ = false;
          return;
        }
        rule = rule == Rule::strict ? Rule::touching : Rule::any;
        failures = 0;
      }
    }
  }

  const std::vector<Point2>& p_;
  std::vector<CornerNode> nodes_;
  std::vector<Index> rings_;   ///< one node of each ring to cut
  std::vector<Index> joined_;  ///< nodes of the rings to cut
  std::vector<Index> reflex_;  ///< reflex corners of the ring being cut, by position
  std::vector<Triple> triangles_;
  std::size_t looks_left_ = 0;
  bool whole_ = true;
};

}  // namespace

CutEars cut_ears(const std::vector<Point2>& positions, const LinkedContours& links) {
  EarCutter cutter(positions, links);
  return {.triangles = cutter.cut(), .whole = cutter.whole()};
}

}  // namespace ligne
