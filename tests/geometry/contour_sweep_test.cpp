#include "geometry/polygons/contour_sweep.hpp"

#include "geometry/flip_edges.hpp"
#include "geometry/polygons/contour_edges.hpp"
#include "geometry/polygons/contour_links.hpp"
#include "geometry/polygons/ear_cutter.hpp"
#include "geometry/predicates.hpp"
#include "geometry/triangulate.hpp"
#include "main/tier.hpp"
#include "polygon_shapes.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using shapes::Contour;
using shapes::Polygon;
using Triples = std::vector<std::array<std::uint32_t, 3>>;

ContourEdges number_edges(const Polygon& polygon) {
  const shapes::Flat flat = shapes::flatten(polygon);
  return number_contour_edges(flat.points, flat.contour_end);
}

std::vector<SweepEdge> pieces_one_by_one(const ContourEdges& contours) {
  std::vector<SweepEdge> pieces;
  for (const SweepEdge& edge : contours.edges) append_pieces(contours.positions, edge, pieces);
  return pieces;
}

/// How often each piece is wound round, without those that cancel out.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> windings(const std::vector<SweepEdge>& pieces) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sum;
  for (const SweepEdge& e : pieces) sum[{e.low, e.high}] += e.winding;
  std::erase_if(sum, [](const auto& entry) { return entry.second == 0; });
  return sum;
}

bool any_cross(const std::vector<Point2>& p, const std::vector<SweepEdge>& pieces) {
  for (const SweepEdge& e : pieces) {
    for (const SweepEdge& f : pieces)
      if (orientation_sign(p[e.low], p[e.high], p[f.low]) * orientation_sign(p[e.low], p[e.high], p[f.high]) < 0 &&
          orientation_sign(p[f.low], p[f.high], p[e.low]) * orientation_sign(p[f.low], p[f.high], p[e.high]) < 0) {
        return true;
      }
  }
  return false;
}

/// Exact for coordinates that are small whole numbers.
double twice_area(const std::vector<Point2>& p, const Triples& triangles) {
  double sum = 0;
  for (const auto& t : triangles) {
    const Point2 a = p[t[1]] - p[t[0]], b = p[t[2]] - p[t[0]];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

double twice_area(const std::vector<Point2>& p, const std::vector<SweepEdge>& pieces) {
  double sum = 0;
  for (const SweepEdge& e : pieces) sum += e.winding * (p[e.low].x * p[e.high].y - p[e.low].y * p[e.high].x);
  return sum;
}

/// How often the pieces wind round a point that lies on none of them.
int winding_at(const std::vector<Point2>& p, const std::vector<SweepEdge>& pieces, Point2 q) {
  int winding = 0;
  for (const SweepEdge& e : pieces) {
    if ((p[e.low].x <= q.x) == (p[e.high].x <= q.x)) continue;
    if (orientation_sign(p[e.low], p[e.high], q) > 0) winding += e.winding;
  }
  return winding;
}

int triangles_at(const std::vector<Point2>& p, const Triples& triangles, Point2 q) {
  return static_cast<int>(std::count_if(triangles.begin(), triangles.end(), [&](const auto& t) {
    return orientation_sign(p[t[0]], p[t[1]], q) > 0 && orientation_sign(p[t[1]], p[t[2]], q) > 0 &&
           orientation_sign(p[t[2]], p[t[0]], q) > 0;
  }));
}

/// The area of what the contours bound, no triangle without area, no corner in the middle of a side.
void expect_right_triangles(const std::vector<Point2>& p, const SweptContours& swept, const Triples& triangles) {
  ASSERT_EQ(twice_area(p, triangles), twice_area(p, swept.pieces));
  for (const auto& t : triangles) {
    ASSERT_GT(orientation_sign(p[t[0]], p[t[1]], p[t[2]]), 0);
    for (int k = 0; k < 3; ++k) {  // no corner in the middle of a side
      std::vector<SweepEdge> side;
      append_pieces(p, {std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]), 1}, side);
      for (std::size_t i = 0; i + 1 < side.size(); ++i) {
        const std::uint32_t middle = side[i].high;
        ASSERT_TRUE(std::none_of(swept.pieces.begin(), swept.pieces.end(),
                                 [&](const SweepEdge& e) { return e.low == middle || e.high == middle; }));
      }
    }
  }
}

/// Everything that sweep_contours() promises, and that ears cover as much.
void expect_right(const Polygon& polygon, std::mt19937_64& random, int& simple_ones) {
  const ContourEdges contours = number_edges(polygon);
  const std::vector<Point2>& p = contours.positions;
  const SweptContours swept = sweep_contours(p, contours.edges);
  const std::vector<SweepEdge> pieces = pieces_one_by_one(contours);
  ASSERT_EQ(windings(swept.pieces), windings(pieces));
  // On no line through two positions: its coordinates have other denominators than the lines' points have there.
  std::uniform_int_distribution<int> cell(-1, 12);
  bool once = true;
  for (int i = 0; i < 40; ++i) {
    const Point2 q(cell(random) + 0.3071, cell(random) + 0.4219);
    const int winding = winding_at(p, pieces, q);
    once = once && (winding == 0 || winding == 1);
    if (swept.simple) {
      ASSERT_EQ(triangles_at(p, swept.triangles, q), winding);
    }
  }
  if (any_cross(p, swept.pieces) || !once) {
    ASSERT_FALSE(swept.simple);
  }
  if (!swept.simple) return;
  ++simple_ones;
  expect_right_triangles(p, swept, swept.triangles);
  Triples flipped = swept.triangles;
  flip_to_delaunay(p, flipped);
  ASSERT_EQ(flipped.size(), swept.triangles.size());
  expect_right_triangles(p, swept, flipped);
  const CutEars ears = cut_ears(p, link_contours(p, pieces));
  ASSERT_TRUE(ears.whole);
  ASSERT_EQ(twice_area(p, ears.triangles), twice_area(p, pieces));
}

TEST(ContourSweep, RandomContoursOnASmallGrid) {
  std::mt19937_64 random(29);
  int simple_ones = 0;
  for (int round = 0; round < 30000; ++round) {
    const int size = 2 + round % 9;
    std::uniform_int_distribution<int> at(0, size), count(1, 3), corners(3, 4 + round % 7);
    Polygon polygon(static_cast<std::size_t>(count(random)));
    for (Contour& c : polygon)
      for (int k = corners(random); k > 0; --k) c.emplace_back(at(random), at(random));
    expect_right(polygon, random, simple_ones);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(simple_ones, 3000);
}

// The border of every cell as a contour of its own, or of cells that one contour runs round: all edges lie on others.
TEST(ContourSweep, RandomCells) {
  std::mt19937_64 random(31);
  int simple_ones = 0;
  for (int round = 0; round < 3000; ++round) {
    std::uniform_int_distribution<int> size(1, 3), at(0, 8);
    Polygon polygon{shapes::rectangle(0, 0, 11, 11)};
    std::vector<bool> taken(144, false);
    for (int k = 0; k < 1 + round % 25; ++k) {
      const int x0 = at(random), y0 = at(random), x1 = x0 + size(random), y1 = y0 + size(random);
      bool free = true;
      for (int x = x0; x < x1; ++x)
        for (int y = y0; y < y1; ++y) free = free && !taken[static_cast<std::size_t>(12 * x + y)];
      if (!free) continue;
      for (int x = x0; x < x1; ++x)
        for (int y = y0; y < y1; ++y) taken[static_cast<std::size_t>(12 * x + y)] = true;
      polygon.push_back(shapes::rectangle(x0, y0, x1, y1));
      Contour& c = polygon.back();
      std::rotate(c.begin(), c.begin() + round % 4, c.end());
      if (round % 3 == 0) std::reverse(c.begin(), c.end());
    }
    expect_right(polygon, random, simple_ones);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ(simple_ones, 3000);
}

TEST(ContourSweep, Shapes) {
  for (const shapes::Shape& shape : shapes::all_shapes()) {
    SCOPED_TRACE(shape.name);
    for (const int corners : {100, 3000, !shape.simple ? 3000 : test::runs_all() ? 100000 : 10000}) {
      const ContourEdges contours = number_edges(shape.make(corners));
      SweptContours swept = sweep_contours(contours.positions, contours.edges);
      if (shape.simple || corners > 100) {  // few corners may happen not to cross
        EXPECT_EQ(swept.simple, shape.simple);
      }
      if (!swept.simple) continue;
      flip_to_delaunay(contours.positions, swept.triangles);
      const double area = twice_area(contours.positions, contours.edges);
      EXPECT_NEAR(twice_area(contours.positions, swept.triangles), area, 1e-9 * std::abs(area));
      // Euler: a region of h holes and c corners is cut into c - 2 + 2 h triangles, and less where it touches itself.
      EXPECT_LE(swept.triangles.size(), 2 * contours.edges.size());
    }
  }
}

// Contours that cross themselves, or run round several times: linked and cut in bounded time.

using Index = std::uint32_t;

TEST(CrossingContours, EdgesAreCutAsOneByOne) {
  std::mt19937_64 random(3);
  const auto ends_of = [](const std::vector<SweepEdge>& pieces) {
    std::vector<std::tuple<Index, Index, int>> ends;
    for (const SweepEdge& e : pieces) ends.emplace_back(e.low, e.high, e.winding);
    return ends;
  };
  for (const auto& [columns, rows] : {std::pair{70, 70}, {1, 900}, {900, 1}, {3, 400}}) {
    std::vector<Point2> p;
    for (int i = 0; i < columns * rows; ++i) p.emplace_back(i / rows, i % rows);
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
