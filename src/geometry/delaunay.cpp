// Edges come in pairs: e runs one way, e ^ 1 the other way. The edges that leave a point form a ring, counter-clockwise;
// with that
//   the next edge round the face on the left of e is the one before e ^ 1 in its ring,
//   the previous one round the face on its left is the reverse of the one behind e in its ring,
//   the previous one round the face on its right is the one behind e ^ 1 in its ring.

#include "geometry/delaunay.hpp"

#include <utility>

namespace ligne {
namespace {

/// Sign of: d lies within the circle through a, b, c, which turn counter-clockwise. Differences have 27 bits, their squares'
/// sums 55, the products of three 111: exact in 128.
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

  explicit Triangulation(std::span<const LatticePoint> points) : points_(points) {
    next_.reserve(6 * points.size());
    previous_.reserve(6 * points.size());
    from_.reserve(6 * points.size());
  }

  Delaunay run() {
    if (points_.size() >= 2) divide(0, static_cast<std::uint32_t>(points_.size()));
    return collect();
  }

 private:
  /// The hull's edges that leave its lowest point (by x) counter-clockwise, and its highest one clockwise.
  using Ends = std::pair<Edge, Edge>;

  std::uint32_t to(Edge e) const { return from_[e ^ 1]; }
  Edge next_left(Edge e) const { return previous_[e ^ 1]; }
  Edge previous_right(Edge e) const { return next_[e ^ 1]; }

  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orientation(points_[a], points_[b], points_[c]);
  }
  bool is_left(std::uint32_t p, Edge e) const { return turn(p, from_[e], to(e)) > 0; }
  bool is_right(std::uint32_t p, Edge e) const { return turn(p, to(e), from_[e]) > 0; }
  bool circle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return in_circle(points_[a], points_[b], points_[c], points_[d]);
  }

  Edge make(std::uint32_t a, std::uint32_t b) {
    const auto e = static_cast<Edge>(from_.size());
    for (const Edge half : {e, e + 1}) {
      next_.push_back(half);
      previous_.push_back(half);
    }
    from_.push_back(a);
    from_.push_back(b);
    return e;
  }

  /// Joins two rings, or divides one.
  void splice(Edge a, Edge b) {
    std::swap(next_[a], next_[b]);
    previous_[next_[a]] = a;
    previous_[next_[b]] = b;
  }

  /// An edge from the end of a to the beginning of b, so that all three have one face on their left.
  Edge connect(Edge a, Edge b) {
    const Edge e = make(to(a), from_[b]);
    splice(e, next_left(a));
    splice(e ^ 1, b);
    return e;
  }

  void remove(Edge e) {
    splice(e, previous_[e]);
    splice(e ^ 1, previous_[e ^ 1]);
    from_[e] = from_[e ^ 1] = Delaunay::kNone;
  }

  Ends divide(std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t count = end - begin;
    if (count == 2) {
      const Edge a = make(begin, begin + 1);
      return {a, a ^ 1};
    }
    if (count == 3) return three(begin);
    const std::uint32_t middle = begin + count / 2;
    const Ends left = divide(begin, middle), right = divide(middle, end);
    return merge(left, right);
  }

  Ends three(std::uint32_t p) {
    const Edge a = make(p, p + 1), b = make(p + 1, p + 2);
    splice(a ^ 1, b);
    const double turned = turn(p, p + 1, p + 2);
    if (turned == 0) return {a, b ^ 1};
    const Edge c = connect(b, a);
    return turned > 0 ? Ends{a, b ^ 1} : Ends{c ^ 1, c};
  }

  Ends merge(Ends left, Ends right) {
    Edge inner_left = left.second, inner_right = right.first;
    for (;;) {  // the common tangent from below
      if (is_left(from_[inner_right], inner_left)) {
        inner_left = next_left(inner_left);
      } else if (is_right(from_[inner_left], inner_right)) {
        inner_right = previous_right(inner_right);
      } else {
        break;
      }
    }
    Edge base = connect(inner_right ^ 1, inner_left);
    if (from_[inner_left] == from_[left.first]) left.first = base ^ 1;
    if (from_[inner_right] == from_[right.second]) right.second = base;
    const auto is_above = [&](Edge e) { return is_right(to(e), base); };
    for (;;) {  // from one cross edge to the next above it
      Edge candidate = next_[base ^ 1];
      if (is_above(candidate)) {
        while (circle(to(base), from_[base], to(candidate), to(next_[candidate]))) {
          const Edge after = next_[candidate];
          remove(candidate);
          candidate = after;
        }
      }
      Edge other = previous_[base];
      if (is_above(other)) {
        while (circle(to(base), from_[base], to(other), to(previous_[other]))) {
          const Edge after = previous_[other];
          remove(other);
          other = after;
        }
      }
      const bool left_above = is_above(candidate), right_above = is_above(other);
      if (!left_above && !right_above) return {left.first, right.second};
      const bool take_right =
          !left_above || (right_above && circle(to(candidate), from_[candidate], from_[other], to(other)));
      base = take_right ? connect(other, base ^ 1) : connect(base ^ 1, candidate ^ 1);
    }
  }

  /// The faces on the left of all edges that are triangles.
  Delaunay collect() const {
    Delaunay result;
    result.triangles.reserve(2 * points_.size());
    result.neighbours.reserve(2 * points_.size());
    std::vector<std::uint32_t> face(from_.size(), Delaunay::kNone);
    for (Edge e = 0; e < from_.size(); ++e) {
      if (from_[e] == Delaunay::kNone || face[e] != Delaunay::kNone) continue;
      const Edge b = next_left(e), c = next_left(b);
      if (next_left(c) != e || !(turn(from_[e], from_[b], from_[c]) > 0)) continue;
      face[e] = face[b] = face[c] = static_cast<std::uint32_t>(result.triangles.size());
      result.triangles.push_back({from_[e], from_[b], from_[c]});
      result.neighbours.push_back({e ^ 1, b ^ 1, c ^ 1});
    }
    for (std::array<std::uint32_t, 3>& beyond : result.neighbours) {
      for (std::uint32_t& side : beyond) side = face[side];
    }
    return result;
  }

  std::span<const LatticePoint> points_;
  std::vector<Edge> next_, previous_;  ///< in the ring
  std::vector<std::uint32_t> from_;    ///< kNone for edges that were removed
};

}  // namespace

Delaunay triangulate_delaunay(std::span<const LatticePoint> points) { return Triangulation(points).run(); }

}  // namespace ligne
