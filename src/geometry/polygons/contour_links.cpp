// Phase 1  pieces that run against each other cancel out.
// Phase 2  at every position an arriving piece is followed by the first leaving piece clockwise from it: between the
// two lies one sector of the inside. So every piece has one successor, and the cycles of successors are the loops.

#include "geometry/polygons/contour_links.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "base/stop.hpp"
#include "geometry/polygons/contour_edges.hpp"
#include "geometry/predicates.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;
using DirectedEdge = std::pair<Index, Index>;

/// Removes pairs of pieces that run in opposite directions. Returns the rest ordered by first position.
std::vector<DirectedEdge> cancel_opposite(std::vector<SweepEdge> pieces) {
  const auto ends = [](const SweepEdge& e) { return std::pair{e.low, e.high}; };
  std::ranges::sort(pieces, [&](const SweepEdge& a, const SweepEdge& b) { return ends(a) < ends(b); });
  std::vector<DirectedEdge> rest;
  for (std::size_t i = 0; i < pieces.size();) {
    const auto [low, high] = ends(pieces[i]);
    long winding = 0;
    for (; i < pieces.size() && pieces[i].low == low && pieces[i].high == high; ++i) winding += pieces[i].winding;
    const DirectedEdge left_over = winding > 0 ? DirectedEdge{low, high} : DirectedEdge{high, low};
    rest.insert(rest.end(), static_cast<std::size_t>(std::abs(winding)), left_over);
  }
  std::ranges::sort(rest);
  return rest;
}

/// The edges that leave one position, in clockwise order; each is taken once.
class LeavingEdges {
 public:
  /// `first` is the index of the first edge that begins at `centre`.
  LeavingEdges(const std::vector<Point2>& p, Index centre, std::span<const DirectedEdge> edges, std::size_t first)
      : p_(p), centre_(centre), order_(edges.size()), free_(edges.size() + 1) {
    for (std::size_t k = 0; k < edges.size(); ++k) order_[k] = {edges[k].second, static_cast<Index>(first + k)};
    std::ranges::sort(order_, [&](const Leaving& a, const Leaving& b) {
      const bool left_a = is_left(a.to), left_b = is_left(b.to);
      if (left_a != left_b) return left_a;
      const int turn = a.to == b.to ? 0 : orientation_sign(p_[centre_], p_[a.to], p_[b.to]);
      return turn != 0 ? turn < 0 : a.edge < b.edge;
    });
    std::iota(free_.begin(), free_.end(), std::size_t{0});
  }

  /// Takes the first free edge clockwise from just behind the direction to `start`.
  Index take(Index start) {
    const bool left_start = is_left(start);
    const auto after = std::partition_point(order_.begin(), order_.end(), [&](const Leaving& leaving) {
      const bool left = is_left(leaving.to);
      return left != left_start ? left : orientation_sign(p_[centre_], p_[leaving.to], p_[start]) <= 0;
    });
    std::size_t at = find_free(static_cast<std::size_t>(after - order_.begin()));
    if (at == order_.size()) at = find_free(0);
    free_[at] = at + 1;
    return order_[at].edge;
  }

 private:
  struct Leaving {
    Index to, edge;
  };

  /// Positions are numbered from left to right, and upwards where x is equal. So clockwise from straight down,
  /// directions to lower numbers fill one half turn and those to higher numbers the other. Within each half the sign of
  /// a turn orders them.
  bool is_left(Index to) const { return to < centre_; }

  /// The first free place at or behind `at`; the end if there is none.
  std::size_t find_free(std::size_t at) {
    std::size_t root = at;
    while (free_[root] != root) root = free_[root];
    while (free_[at] != root) at = std::exchange(free_[at], root);
    return root;
  }

  const std::vector<Point2>& p_;
  Index centre_;
  std::vector<Leaving> order_;
  std::vector<std::size_t> free_;  ///< per place in the order: a place at or behind it; the place itself while it is
                                   ///< free
};

/// The successor of every edge: a permutation, since equally many edges arrive at a position and leave it.
std::vector<Index> link_edges(const std::vector<Point2>& p, const std::vector<DirectedEdge>& edges) {
  std::vector<std::size_t> arriving(edges.size());
  std::iota(arriving.begin(), arriving.end(), std::size_t{0});
  std::ranges::stable_sort(arriving, [&](std::size_t a, std::size_t b) { return edges[a].second < edges[b].second; });
  std::vector<Index> successor(edges.size());
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    // Both lists are ordered by position, and have equally many edges at each.
    const Index centre = edges[begin].first;
    while (end < edges.size() && edges[end].first == centre) ++end;
    if (end - begin == 1) {
      successor[arriving[begin]] = static_cast<Index>(begin);
      continue;
    }
    LeavingEdges leaving(p, centre, std::span(edges).subspan(begin, end - begin), begin);
    for (std::size_t k = begin; k < end; ++k) successor[arriving[k]] = leaving.take(edges[arriving[k]].first);
    check_stop();
  }
  return successor;
}

/// Drops loops that repeat another loop in the same direction: they bound nothing new.
void drop_repeated(std::vector<std::vector<Index>>& loops) {
  if (loops.size() < 2) return;
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return loops[a] < loops[b]; });
  std::vector<bool> repeated(loops.size(), false);
  for (std::size_t k = 1; k < order.size(); ++k) repeated[order[k]] = loops[order[k]] == loops[order[k - 1]];
  std::size_t kept = 0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (repeated[i]) continue;
    if (kept != i) loops[kept] = std::move(loops[i]);
    ++kept;
  }
  loops.resize(kept);
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
    if (sign != 0) (sign > 0 ? links.outer : links.holes).push_back(std::move(loop));
  }
  drop_repeated(links.outer);
  drop_repeated(links.holes);
  return links;
}

}  // namespace ligne
