/// Contours that cross themselves, or run round several times: linked and cut in bounded time.

#include "geometry/polygons/contour_edges.hpp"
#include "geometry/polygons/contour_links.hpp"
#include "geometry/predicates.hpp"
#include "geometry/triangulate.hpp"
#include "main/tier.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using Index = std::uint32_t;

/// Distinct positions of a small grid, in order.
std::vector<Point2> grid_positions(int columns, int rows) {
  std::vector<Point2> p;
  for (int x = 0; x < columns; ++x)
    for (int y = 0; y < rows; ++y) p.emplace_back(x, y);
  return p;
}

std::vector<std::array<Index, 3>> ends_of(const std::vector<SweepEdge>& pieces) {
  std::vector<std::array<Index, 3>> ends;
  for (const SweepEdge& e : pieces) ends.push_back({e.low, e.high, static_cast<Index>(e.winding)});
  return ends;
}

TEST(CrossingContours, EdgesAreCutAsOneByOne) {
  std::mt19937_64 random(3);
  for (const auto& p : {grid_positions(70, 70), grid_positions(1, 900), grid_positions(900, 1), grid_positions(3, 400)}) {
    EdgeCutter cutter(p);
    std::uniform_int_distribution<Index> any(0, static_cast<Index>(p.size() - 1));
    std::size_t cuts = 0;
    for (int i = 0; i < 4000; ++i) {
      const Index a = any(random), b = any(random);
      if (a == b) continue;
      const SweepEdge edge{std::min(a, b), std::max(a, b), i % 2 ? 1 : -1};
      std::vector<SweepEdge> expected, found;
      append_pieces(p, edge, expected);
      cutter.append_pieces(edge, found);
      ASSERT_EQ(ends_of(found), ends_of(expected));
      cuts += found.size() - 1;
    }
    EXPECT_GT(cuts, 1000u);
  }
}

/// The direction from `centre` to `to`, clockwise from that to `start`: an exact order of a few directions.
bool is_sooner(const std::vector<Point2>& p, Index centre, Index start, Index a, Index b) {
  const auto sector = [&](Index to) {
    const int side = orientation_sign(p[centre], p[start], p[to]);
    if (side != 0) return side < 0 ? 0 : 2;
    return (to > centre) == (start > centre) ? 3 : 1;
  };
  if (sector(a) != sector(b)) return sector(a) < sector(b);
  return orientation_sign(p[centre], p[a], p[b]) < 0;
}

/// The loops as their definition has them: every edge looks at all that leave the position where it arrives.
std::vector<std::vector<Index>> loops_one_by_one(const std::vector<Point2>& p, std::vector<std::pair<Index, Index>> edges) {
  std::sort(edges.begin(), edges.end());
  std::vector<std::size_t> successor(edges.size());
  std::vector<bool> taken(edges.size(), false), seen(edges.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    std::size_t best = edges.size();
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (taken[k] || edges[k].first != edges[i].second) continue;
      if (best == edges.size() || is_sooner(p, edges[i].second, edges[i].first, edges[k].second, edges[best].second))
        best = k;
    }
    taken[best] = true;
    successor[i] = best;
  }
  std::vector<std::vector<Index>> loops;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (seen[i]) continue;
    loops.emplace_back();
    for (std::size_t k = i; !seen[k]; k = successor[k]) {
      seen[k] = true;
      loops.back().push_back(edges[k].first);
    }
  }
  return loops;
}

TEST(CrossingContours, LoopsTurnRightAtEveryPosition) {
  std::mt19937_64 random(5);
  const std::vector<Point2> p = grid_positions(5, 5);
  std::size_t repeated = 0;
  for (int round = 0; round < 3000; ++round) {
    std::uniform_int_distribution<Index> any(0, static_cast<Index>(p.size() - 1));
    std::vector<Point2> points(static_cast<std::size_t>(3 + round % 40));
    for (Point2& q : points) q = p[any(random)];
    const std::vector<Index> end{static_cast<Index>(points.size())};
    const ContourEdges contours = number_contour_edges(points, end);
    std::vector<SweepEdge> pieces;
    for (const SweepEdge& edge : contours.edges) append_pieces(contours.positions, edge, pieces);
    std::map<std::pair<Index, Index>, int> windings;
    for (const SweepEdge& e : pieces) windings[{e.low, e.high}] += e.winding;
    std::vector<std::pair<Index, Index>> directed;
    for (const auto& [ends, n] : windings) {
      const auto [low, high] = ends;
      for (int k = 0; k < std::abs(n); ++k) directed.push_back(n > 0 ? std::pair(low, high) : std::pair(high, low));
    }
    std::vector<std::vector<Index>> expected = loops_one_by_one(contours.positions, directed);
    std::sort(expected.begin(), expected.end());
    const std::size_t all = expected.size();
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    repeated += all - expected.size();
    const LinkedContours links = link_contours(contours.positions, pieces);
    for (const auto* loops : {&links.outer, &links.holes})
      for (const std::vector<Index>& loop : *loops) {
        const auto at = std::lower_bound(expected.begin(), expected.end(), loop);
        ASSERT_TRUE(at != expected.end() && *at == loop) << "round " << round;
        expected.erase(at);
      }
    // Those that are left have no area at their first corner.
    for (const std::vector<Index>& loop : expected) {
      std::vector<Point2> corners;
      for (const Index i : loop) corners.push_back(contours.positions[i]);
      EXPECT_EQ(sign_at_smallest_corner(corners), 0);
    }
  }
  EXPECT_GT(repeated, 0u);
}

TEST(CrossingContours, RunningRoundManyTimesIsRunningRoundOnce) {
  const Point2 square[] = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
  std::vector<Point2> points;
  for (Index k = 0; k < 400'000; ++k) points.push_back(square[k % 4]);
  const std::vector<Index> end{static_cast<Index>(points.size())};
  bool whole = false;
  EXPECT_EQ(triangulate(points, end, &whole).size(), 2u);
  EXPECT_TRUE(whole);
}

TEST(CrossingContours, AScribbleIsCutInPart) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<Point2> points(test::runs_all() ? 100'000 : 40'000);
  for (Point2& q : points) q = {any(random), any(random)};
  const std::vector<Index> end{static_cast<Index>(points.size())};
  bool whole = true;
  const auto triangles = triangulate(points, end, &whole);
  EXPECT_FALSE(whole);
  EXPECT_GT(triangles.size(), 100u);
}

}  // namespace
}  // namespace ligne
