// Scan conversion: parity at every vertex, holes, horizontal edges, accumulators.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "visibility/common/scan_conversion.hpp"

namespace ligne {
namespace {

double covered(const std::vector<PolygonRun>& runs) {
  double sum = 0;
  for (const PolygonRun& r : runs) sum += r.u1 - r.u0;
  return sum;
}

const PolygonRun* run_on(const std::vector<PolygonRun>& runs, std::uint32_t line, int which = 0) {
  for (const PolygonRun& r : runs) {
    if (r.line == line && which-- == 0) return &r;
  }
  return nullptr;
}

TEST(ScanConversion, SquareCoversItsLinesOnce) {
  const std::vector<GridPoint> square{{1, 1, 0}, {5, 1, 0}, {5, 4, 3}, {1, 4, 3}};
  const std::vector<std::uint32_t> end{4};
  const auto runs = scan_polygon(square, end, 10);
  ASSERT_EQ(runs.size(), 3u);  // lines 1, 2, 3: the lower side belongs to what lies below it
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(runs[i].line, i + 1);
    EXPECT_EQ(runs[i].u0, 1);
    EXPECT_EQ(runs[i].u1, 5);
    EXPECT_EQ(runs[i].z0, i);
  }
}

TEST(ScanConversion, HoleIsLeftOut) {
  const std::vector<GridPoint> points{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0},
                                      {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}};
  const std::vector<std::uint32_t> end{4, 8};
  const auto runs = scan_polygon(points, end, 9);
  EXPECT_EQ(covered(runs), 9 * 9 - 3 * 3);
  ASSERT_NE(run_on(runs, 4, 1), nullptr);
  EXPECT_EQ(run_on(runs, 4, 0)->u1, 3);
  EXPECT_EQ(run_on(runs, 4, 1)->u0, 6);
}

/// Vertices exactly on lines: a peak up, a peak down, a bend, a horizontal step.
TEST(ScanConversion, VerticesOnLines) {
  const std::vector<GridPoint> points{{0, 0, 0}, {4, 4, 0}, {8, 0, 0}, {8, 6, 0}, {6, 6, 0}, {6, 8, 0}, {0, 8, 0}};
  const std::vector<std::uint32_t> end{7};
  const auto runs = scan_polygon(points, end, 20);
  EXPECT_EQ(run_on(runs, 0)->u1, 0);  // the peaks at the top have length zero, and are there
  EXPECT_EQ(run_on(runs, 2, 0)->u1, 2);
  EXPECT_EQ(run_on(runs, 2, 1)->u0, 6);
  EXPECT_EQ(run_on(runs, 4, 0)->u1 - run_on(runs, 4, 0)->u0, 8);  // the valley closes
  EXPECT_EQ(run_on(runs, 7, 0)->u1, 6);
  EXPECT_EQ(run_on(runs, 8), nullptr);
}

TEST(ScanConversion, HorizontalAndTinyEdgesBoundNothing) {
  const std::vector<std::uint32_t> end{3};
  EXPECT_TRUE(scan_polygon(std::vector<GridPoint>{{0, 2, 0}, {5, 2, 0}, {9, 2, 0}}, end, 9).empty());
  EXPECT_TRUE(scan_polygon(std::vector<GridPoint>{{0, 2.2, 0}, {5, 2.4, 0}, {9, 2.9, 0}}, end, 9).empty());
  EXPECT_TRUE(scan_polygon(std::vector<GridPoint>{}, std::vector<std::uint32_t>{}, 9).empty());
}

/// Lines outside the grid are no lines.
TEST(ScanConversion, PolygonLargerThanTheGrid) {
  const std::vector<GridPoint> points{{0, -50, 0}, {10, -50, 0}, {10, 50, 0}, {0, 50, 0}};
  const std::vector<std::uint32_t> end{4};
  const auto runs = scan_polygon(points, end, 7);
  EXPECT_EQ(runs.size(), 7u);
  EXPECT_EQ(covered(runs), 70);
}

/// Random polygons: the runs' sum comes to the area, and each lies where the sides are.
TEST(ScanConversion, AreaOfRandomTriangles) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 4000);
  for (int i = 0; i < 50; ++i) {
    const std::vector<GridPoint> t{
        {place(random), place(random), 0}, {place(random), place(random), 0}, {place(random), place(random), 0}};
    const double area = std::abs((t[1].u - t[0].u) * (t[2].v - t[0].v) - (t[1].v - t[0].v) * (t[2].u - t[0].u)) / 2;
    const double sum = covered(scan_polygon(t, std::vector<std::uint32_t>{3}, 4000));
    EXPECT_NEAR(sum, area, 4000 + 0.001 * area);  // a line is a sample
  }
}

/// Figure 2.38: an edge that moves by less than half a unit a line. Its whole place is rounded from a real one, and so it
/// does move.
TEST(ScanConversion, SteepEdgeMovesThoughEachStepIsBelowHalf) {
  EdgeTrack t = EdgeTrack::between({10, 0, 0}, {40, 100, 50}, 200);
  for (int line = 0; line < 100; ++line, t.advance()) {
    ASSERT_NEAR(t.u, 10 + 0.3 * line, 1e-12);
    ASSERT_NEAR(t.z, 0.5 * line, 1e-12);
    ASSERT_NEAR(t.u, EdgeTrack::between({10, 0, 0}, {40, 100, 50}, 200).on(static_cast<std::uint32_t>(line)).u, 1e-11);
  }
  double frozen = 10;
  for (int line = 0; line < 100; ++line) frozen = std::floor(frozen + 0.3 + 0.5);
  EXPECT_EQ(frozen, 10);
}

/// The accumulators stay true over thousands of lines.
TEST(ScanConversion, AccumulatorsDoNotDrift) {
  EdgeTrack t = EdgeTrack::between({1.1, 0.3, 7.7}, {9876.5, 32767.9, -1}, 40000);
  for (std::uint32_t line = t.first; line < t.last; ++line, t.advance()) {
    const double share = (line - 0.3) / (32767.9 - 0.3);
    ASSERT_NEAR(t.u, 1.1 + share * (9876.5 - 1.1), 1e-7);
  }
}

TEST(ScanConversion, WholeGridRoundsPoints) {
  LineGrid grid;
  grid.spacing = 10;
  grid.whole = true;
  EXPECT_EQ(grid.u(14.9), 1);
  EXPECT_EQ(grid.u(15), 2);
  EXPECT_EQ(grid.v(-16), -2);
  EXPECT_EQ(grid.x(2), 20);
}

}  // namespace
}  // namespace ligne
