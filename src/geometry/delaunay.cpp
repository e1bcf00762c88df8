// Edges come in pairs: e runs one way, e ^ 1 the other way. The edges that leave a point form a ring in
// counter-clockwise order. Hence
// - the next edge around the face on the left of e is the predecessor of e ^ 1 in its ring,
// - the previous edge around the face on the left of e is the reverse of the successor of e in its ring,
// - the previous edge around the face on the right of e is the successor of e ^ 1 in its ring.
//
// The points are sorted along a Morton curve, so the highest bit in which the keys of a range differ divides it in x or
// in y, with one half before the other. A division in y is a division in x of the points rotated by a quarter turn, (x,
// y) to (y, -x), and the rotation changes none of the signs that decide.

#include "geometry/delaunay.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "base/no_index.hpp"
#include "geometry/morton.hpp"

namespace ligne {
namespace {

/// Sign of the in-circle determinant: positive if d lies within the circle through a, b, c, which turn
/// counter-clockwise. Differences have 27 bits, sums of their squares 55, products of all three 111: exact in 128.
bool in_circle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  struct Lifted {
    std::int64_t x, y, square;
  };
  const auto lifted = [&](LatticePoint p) {
    const std::int64_t x = std::int64_t{p.x} - d.x, y = std::int64_t{p.y} - d.y;
    return Lifted{x, y, x * x + y * y};
  };
  const Lifted p = lifted(a), q = lifted(b), r = lifted(c);
  const auto minor = [](const Lifted& s, const Lifted& t) { return s.x * t.y - t.x * s.y; };
  __extension__ using Wide = __int128;
  return Wide{minor(q, r)} * p.square + Wide{minor(r, p)} * q.square + Wide{minor(p, q)} * r.square > 0;
}

class Triangulation {
 public:
  using Edge = std::uint32_t;

  explicit Triangulation(std::span<const LatticePoint> points) {
    edges_.reserve(6 * points.size());
    points_.reserve(points.size());
    keys_.reserve(points.size());
    for (const LatticePoint& p : points) {
      points_.push_back({p, static_cast<std::uint32_t>(points_.size())});
      keys_.push_back(morton_key(p));
      assert(keys_.size() < 2 || keys_[keys_.size() - 2] < keys_.back());
    }
  }

  Delaunay run() {
    if (points_.size() >= 2) divide(0, static_cast<std::uint32_t>(points_.size()), Cut::by_keys);
    return collect();
  }

 private:
  struct Place {
    LatticePoint at;
    std::uint32_t number;  ///< index among the caller's points
  };

  /// Axis across which a set of points is divided, and the way the place of the division is chosen.
  enum class Axis { x, y };
  enum class Cut { by_keys, in_halves };

  /// Two edges of the hull: counter-clockwise from its lowest point along an axis, and clockwise from its highest.
  using Ends = std::pair<Edge, Edge>;

  struct HalfEdge {
    Edge next, previous;  ///< in the ring around `from`
    std::uint32_t from;   ///< kNone for removed edges
    std::uint32_t face;   ///< on the left; set at the end
  };

  std::uint32_t from(Edge e) const { return edges_[e].from; }
  std::uint32_t to(Edge e) const { return edges_[e ^ 1].from; }
  Edge next(Edge e) const { return edges_[e].next; }
  Edge previous(Edge e) const { return edges_[e].previous; }
  Edge next_left(Edge e) const { return previous(e ^ 1); }
  Edge previous_right(Edge e) const { return next(e ^ 1); }

  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orientation(points_[a].at, points_[b].at, points_[c].at);
  }
  bool is_left(std::uint32_t p, Edge e) const { return turn(p, from(e), to(e)) > 0; }
  bool is_right(std::uint32_t p, Edge e) const { return turn(p, to(e), from(e)) > 0; }
  bool circle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return in_circle(points_[a].at, points_[b].at, points_[c].at, points_[d].at);
  }

  Edge make(std::uint32_t a, std::uint32_t b) {
    Edge e = static_cast<Edge>(edges_.size());
    if (removed_.empty()) {
      edges_.resize(edges_.size() + 2);
    } else {
      e = removed_.back();
      removed_.pop_back();
    }
    edges_[e] = {e, e, a, kNone};
    edges_[e + 1] = {e + 1, e + 1, b, kNone};
    return e;
  }

  /// Joins two rings, or divides one ring.
  void splice(Edge a, Edge b) {
    std::swap(edges_[a].next, edges_[b].next);
    edges_[edges_[a].next].previous = a;
    edges_[edges_[b].next].previous = b;
  }

  /// Adds an edge from the end of a to the beginning of b, such that all three have one face on their left.
  Edge connect(Edge a, Edge b) {
    const Edge e = make(to(a), from(b));
    splice(e, next_left(a));
    splice(e ^ 1, b);
    return e;
  }

  void remove(Edge e) {
    splice(e, previous(e));
    splice(e ^ 1, previous(e ^ 1));
    edges_[e].from = edges_[e ^ 1].from = kNone;
    removed_.push_back(e & ~Edge{1});
  }

  /// Orders by the coordinate of the axis, then by the other one as a quarter turn makes it.
  static bool is_before(const Place& a, const Place& b, Axis axis) {
    const LatticePoint &p = a.at, &q = b.at;
    return axis == Axis::x ? std::pair(p.x, p.y) < std::pair(q.x, q.y) : std::pair(p.y, -p.x) < std::pair(q.y, -q.x);
  }
  bool is_before(std::uint32_t a, std::uint32_t b, Axis axis) const { return is_before(points_[a], points_[b], axis); }

  /// `edge` is an edge of the hull, counter-clockwise.
  Ends ends_along(Axis axis, Edge edge) const {
    Edge lowest = edge, highest = edge ^ 1;
    for (Edge e = previous_right(edge); e != edge; e = previous_right(e)) {
      if (is_before(from(e), from(lowest), axis)) lowest = e;
      if (is_before(from(highest), to(e), axis)) highest = e ^ 1;
    }
    return {lowest, highest};
  }

  /// Returns an edge of the hull, counter-clockwise. Calls nest at most as deep as the keys have bits, plus the
  /// halvings.
  Edge divide(std::uint32_t begin, std::uint32_t end, Cut cut) {
    if (end - begin == 2) return make(begin, begin + 1);
    if (end - begin == 3) return three(begin);
    std::uint32_t middle = begin + (end - begin) / 2;
    Axis axis = Axis::x;
    if (cut == Cut::by_keys) {
      const int bit = std::bit_width(keys_[begin] ^ keys_[end - 1]) - 1;
      const auto first = keys_.begin() + begin, last = keys_.begin() + end;
      const auto upper = std::lower_bound(first, last, keys_[end - 1] >> bit << bit);
      // A part with one point has no edge. Then the points are divided into halves by coordinates instead of by keys.
      if (upper - first < 2 || last - upper < 2) return divide(begin, end, Cut::in_halves);
      middle = static_cast<std::uint32_t>(upper - keys_.begin());
      axis = bit % 2 == 0 ? Axis::x : Axis::y;
    } else {
      const auto first = points_.begin();
      axis = longer_axis(begin, end);
      std::nth_element(first + begin, first + middle, first + end,
                       [axis](const Place& a, const Place& b) { return is_before(a, b, axis); });
    }
    const Edge left = divide(begin, middle, cut), right = divide(middle, end, cut);
    return merge(ends_along(axis, left), ends_along(axis, right));
  }

  Axis longer_axis(std::uint32_t begin, std::uint32_t end) const {
    LatticePoint low = points_[begin].at, high = low;
    for (std::uint32_t k = begin; k < end; ++k) {
      const LatticePoint p = points_[k].at;
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return high.x - low.x < high.y - low.y ? Axis::y : Axis::x;
  }

  Edge three(std::uint32_t p) {
    const auto first = points_.begin() + p;
    std::sort(first, first + 3, [](const Place& a, const Place& b) { return is_before(a, b, Axis::x); });
    const Edge a = make(p, p + 1), b = make(p + 1, p + 2);
    splice(a ^ 1, b);
    const double turned = turn(p, p + 1, p + 2);
    if (turned == 0) return a;
    const Edge c = connect(b, a);
    return turned > 0 ? a : c ^ 1;
  }

  /// Returns an edge of the hull, counter-clockwise.
  Edge merge(Ends left, Ends right) {
    Edge inner_left = left.second, inner_right = right.first;
    for (;;) {  // the common tangent from below
      if (is_left(from(inner_right), inner_left)) {
        inner_left = next_left(inner_left);
      } else if (is_right(from(inner_left), inner_right)) {
        inner_right = previous_right(inner_right);
      } else {
        break;
      }
    }
    Edge base = connect(inner_right ^ 1, inner_left);
    const Edge hull = base ^ 1;  // the common tangent
    const auto is_above = [&](Edge e) { return is_right(to(e), base); };
    for (;;) {  // from one cross edge to the next above it
      Edge candidate = next(base ^ 1);
      if (is_above(candidate)) {
        while (circle(to(base), from(base), to(candidate), to(next(candidate)))) {
          const Edge after = next(candidate);
          remove(candidate);
          candidate = after;
        }
      }
      Edge other = previous(base);
      if (is_above(other)) {
        while (circle(to(base), from(base), to(other), to(previous(other)))) {
          const Edge after = previous(other);
          remove(other);
          other = after;
        }
      }
      const bool left_above = is_above(candidate), right_above = is_above(other);
      if (!left_above && !right_above) return hull;
      const bool take_right = !left_above || (right_above && circle(to(candidate), from(candidate), from(other), to(other)));
      base = take_right ? connect(other, base ^ 1) : connect(base ^ 1, candidate ^ 1);
    }
  }

  /// Collects the triangles among the faces on the left of the edges.
  Delaunay collect() {
    Delaunay result;
    result.triangles.reserve(2 * points_.size());
    result.neighbours.reserve(2 * points_.size());
    for (Edge e = 0; e < edges_.size(); ++e) {
      if (from(e) == kNone || edges_[e].face != kNone) continue;
      const Edge b = next_left(e), c = next_left(b);
      if (next_left(c) != e || !(turn(from(e), from(b), from(c)) > 0)) continue;
      edges_[e].face = edges_[b].face = edges_[c].face = static_cast<std::uint32_t>(result.triangles.size());
      result.triangles.push_back({points_[from(e)].number, points_[from(b)].number, points_[from(c)].number});
      result.neighbours.push_back({e ^ 1, b ^ 1, c ^ 1});
    }
    for (std::array<std::uint32_t, 3>& beyond : result.neighbours) {
      for (std::uint32_t& side : beyond) side = edges_[side].face;
    }
    return result;
  }

  std::vector<Place> points_;
  std::vector<std::uint64_t> keys_;  ///< of the points in the order given
  std::vector<HalfEdge> edges_;
  std::vector<Edge> removed_;  ///< pairs that can be reused
};

}  // namespace

Delaunay triangulate_delaunay(std::span<const LatticePoint> points) { return Triangulation(points).run(); }

}  // namespace ligne
