// Phase 1  pieces that run against each other cancel out.
// Phase 2  at every position an arriving piece is followed by the first leaving piece clockwise from it: between the two
//          lies one sector of the inside. That gives every piece one successor; its cycles are the loops.

#include "geometry/contour_links.hpp"

#include <algorithm>
#include <utility>

#include "geometry/contour_edges.hpp"
#include "geometry/predicates.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;
using DirectedEdge = std::pair<Index, Index>;

/// Takes away pieces in pairs that run against each other. Returns the rest ordered by their first position.
std::vector<DirectedEdge> cancel_opposite(std::vector<SweepEdge> pieces) {
  const auto ends = [](const SweepEdge& e) { return std::pair{e.low, e.high}; };
  std::sort(pieces.begin(), pieces.end(), [&](const SweepEdge& a, const SweepEdge& b) { return ends(a) < ends(b); });
  std::vector<DirectedEdge> rest;
  for (std::size_t i = 0; i < pieces.size();) {
    const auto [low, high] = ends(pieces[i]);
    long winding = 0;
    for (; i < pieces.size() && pieces[i].low == low && pieces[i].high == high; ++i) winding += pieces[i].winding;
    const DirectedEdge left_over = winding > 0 ? DirectedEdge{low, high} : DirectedEdge{high, low};
    rest.insert(rest.end(), static_cast<std::size_t>(std::abs(winding)), left_over);
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

LinkedContours link_contours(const std::vector<Point2>& p, const std::vector<SweepEdge>& pieces) {
  LinkedContours links;
  const std::vector<DirectedEdge> edges = cancel_opposite(pieces);
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
