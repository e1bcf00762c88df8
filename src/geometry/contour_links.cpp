// Phase 1  equal points become one position; positions are numbered in lexicographic order, so the positions on an edge
//          have numbers between those of its ends, in the order in which the edge meets them.
// Phase 2  every edge is cut at the positions that lie on it; the outer contour is taken counter-clockwise, holes clockwise.
// Phase 3  pieces that run against each other cancel out.
// Phase 4  at every position an arriving piece is followed by the first leaving piece clockwise from it: between the two
//          lies one sector of the inside. That gives every piece one successor; its cycles are the loops.

#include "geometry/contour_links.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/predicates.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;
using DirectedEdge = std::pair<Index, Index>;

bool lexicographically_less(Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Sign of the turn at the lexicographically smallest corner of a contour; -1 wins when the contour passes it again.
int sign_at_smallest_corner(std::span<const Point2> contour) {
  const std::size_t n = contour.size();
  const Point2 smallest = *std::min_element(contour.begin(), contour.end(), lexicographically_less);
  int sign = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (contour[i] != smallest) continue;
    std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    while (before != i && contour[before] == smallest) before = (before + n - 1) % n;
    while (after != i && contour[after] == smallest) after = (after + 1) % n;
    const int turn = orientation_sign(contour[before], contour[i], contour[after]);
    if (turn != 0 && sign >= 0) sign = turn;
  }
  return sign;
}

/// Fills positions and source; returns the position of every point.
std::vector<Index> number_positions(std::span<const Point2> points, LinkedContours& links) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return lexicographically_less(points[a], points[b]); });
  std::vector<Index> position(points.size());
  for (const Index i : order) {
    if (links.positions.empty() || links.positions.back() != points[i]) {
      links.positions.push_back(points[i]);
      links.source.push_back(i);
    }
    position[i] = static_cast<Index>(links.positions.size() - 1);
  }
  return position;
}

/// Appends the pieces of the edge u v between the positions that lie on it.
void append_pieces(const std::vector<Point2>& p, Index u, Index v, std::vector<DirectedEdge>& pieces) {
  if (u == v) return;
  const Index first = std::min(u, v), last = std::max(u, v);
  const double y_min = std::min(p[u].y, p[v].y), y_max = std::max(p[u].y, p[v].y);
  const std::size_t begin = pieces.size();
  Index from = first;
  for (Index i = first + 1; i < last; ++i) {
    if (p[i].y < y_min || p[i].y > y_max || orientation_sign(p[first], p[last], p[i]) != 0) continue;
    pieces.emplace_back(from, i);
    from = i;
  }
  pieces.emplace_back(from, last);
  if (u == last) {
    for (std::size_t i = begin; i < pieces.size(); ++i) std::swap(pieces[i].first, pieces[i].second);
  }
}

/// Takes away pieces in pairs that run against each other. Returns the rest ordered by their first position.
std::vector<DirectedEdge> cancel_opposite(std::vector<DirectedEdge> pieces) {
  const auto undirected = [](const DirectedEdge& e) { return std::minmax(e.first, e.second); };
  std::sort(pieces.begin(), pieces.end(), [&](const DirectedEdge& a, const DirectedEdge& b) {
    const auto [a0, a1] = undirected(a);
    const auto [b0, b1] = undirected(b);
    return std::pair{a0, a1} < std::pair{b0, b1};
  });
  std::vector<DirectedEdge> rest;
  for (std::size_t i = 0; i < pieces.size();) {
    const auto [low, high] = undirected(pieces[i]);
    const DirectedEdge key{low, high};
    long upward = 0;
    for (; i < pieces.size() && (pieces[i] == key || pieces[i] == DirectedEdge{key.second, key.first}); ++i) {
      upward += pieces[i] == key ? 1 : -1;
    }
    const DirectedEdge left_over = upward > 0 ? key : DirectedEdge{key.second, key.first};
    rest.insert(rest.end(), static_cast<std::size_t>(std::abs(upward)), left_over);
  }
  std::sort(rest.begin(), rest.end());
  return rest;
}

/// Orders directions at `centre` clockwise, beginning just after the direction to `start`.
class ClockwiseFrom {
 public:
  ClockwiseFrom(const std::vector<Point2>& p, Index centre, Index start) : p_(p), centre_(centre), start_(start) {}
  bool operator()(Index a, Index b) const {
    const int sector_a = sector(a), sector_b = sector(b);
    if (sector_a != sector_b) return sector_a < sector_b;
    return orientation_sign(p_[centre_], p_[a], p_[b]) < 0;
  }

 private:
  /// 0 right of the line to start, 1 straight on behind the centre, 2 left of the line, 3 the direction to start itself.
  int sector(Index to) const {
    const int side = orientation_sign(p_[centre_], p_[start_], p_[to]);
    if (side != 0) return side < 0 ? 0 : 2;
    // Collinear: on the same side of the centre exactly when the numbers are, for they grow along every line.
    return (to > centre_) == (start_ > centre_) ? 3 : 1;
  }
  const std::vector<Point2>& p_;
  Index centre_, start_;
};

/// The successor of every edge; a permutation, since as many edges arrive at a position as leave it.
std::vector<Index> link_edges(const std::vector<Point2>& p, const std::vector<DirectedEdge>& edges) {
  const auto leaving = [&](Index at) {
    return std::lower_bound(edges.begin(), edges.end(), DirectedEdge{at, 0}) - edges.begin();
  };
  std::vector<Index> successor(edges.size());
  std::vector<bool> taken(edges.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [from, at] = edges[i];
    const ClockwiseFrom before(p, at, from);
    std::size_t best = edges.size();
    for (std::size_t k = static_cast<std::size_t>(leaving(at)); k < edges.size() && edges[k].first == at; ++k) {
      if (!taken[k] && (best == edges.size() || before(edges[k].second, edges[best].second))) best = k;
    }
    taken[best] = true;
    successor[i] = static_cast<Index>(best);
  }
  return successor;
}

}  // namespace

int contour_sign(std::span<const Point2> contour) {
  if (contour.size() < 3) return 0;
  double twice_area = 0, size = 0;
  for (std::size_t i = 1; i + 1 < contour.size(); ++i) {
    const Point2 a = contour[i] - contour[0], b = contour[i + 1] - contour[0];
    twice_area += a.x * b.y - a.y * b.x;
    size += std::abs(a.x * b.y) + std::abs(a.y * b.x);
  }
  // Two roundings in each product's factors, one each in product, difference and sum over n terms, to first order.
  const double bound = (static_cast<double>(contour.size()) + 5) * std::numeric_limits<double>::epsilon() * size;
  if (std::abs(twice_area) > bound) return twice_area > 0 ? 1 : -1;
  return sign_at_smallest_corner(contour);
}

LinkedContours link_contours(std::span<const Point2> points, std::span<const std::uint32_t> contour_end) {
  LinkedContours links;
  const std::vector<Index> position = number_positions(points, links);
  const std::vector<Point2>& p = links.positions;

  std::vector<DirectedEdge> pieces;
  std::size_t begin = 0;
  for (std::size_t c = 0; c < contour_end.size(); ++c) {
    const std::size_t end = contour_end[c];
    const int wanted = c == 0 ? 1 : -1;
    const bool turn_round = contour_sign(points.subspan(begin, end - begin)) != wanted;
    for (std::size_t i = begin; i < end; ++i) {
      const Index u = position[i], v = position[i + 1 < end ? i + 1 : begin];
      if (turn_round)
        append_pieces(p, v, u, pieces);
      else
        append_pieces(p, u, v, pieces);
    }
    begin = end;
  }
  const std::vector<DirectedEdge> edges = cancel_opposite(std::move(pieces));
  const std::vector<Index> successor = link_edges(p, edges);

  std::vector<bool> seen(edges.size(), false);
  std::vector<Point2> corners;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (seen[i]) continue;
    std::vector<Index> loop;
    corners.clear();
    for (std::size_t k = i; !seen[k]; k = successor[k]) {
      seen[k] = true;
      loop.push_back(edges[k].first);
      corners.push_back(p[edges[k].first]);
    }
    const int sign = sign_at_smallest_corner(corners);
    if (sign > 0) links.outer.push_back(std::move(loop));
    if (sign < 0) links.holes.push_back(std::move(loop));
  }
  return links;
}

}  // namespace ligne
