/// Joining strokes at their ends, and the index of ends that it asks: known answers.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "plotting/paths/chain_ends.hpp"
#include "plotting/paths/end_tree.hpp"
#include "plotting/paths/optimize.hpp"
#include "polylines_of.hpp"

namespace ligne {
namespace {

using namespace test;

TEST(JoinStrokes, EndsThatMeetBecomeOneStrokeWhateverTheirDirection) {
  const Polylines joined = join_strokes(polylines_of({{{0, 0}, {10, 0}}, {{20, 5}, {10, 0}}, {{20, 5}, {30, 0}}}), {});
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].size(), 4u);
  EXPECT_NEAR(total_length(joined), 10 + 2 * std::hypot(10, 5), 1e-5);
}

TEST(JoinStrokes, EndsWithinTheToleranceAndNotBeyond) {
  EXPECT_EQ(join_strokes(polylines_of({{{0, 0}, {10, 0}}, {{10.04, 0}, {20, 5}}}), {}).size(), 1u);
  EXPECT_EQ(join_strokes(polylines_of({{{0, 0}, {10, 0}}, {{10.06, 0}, {20, 5}}}), {}).size(), 2u);
}

TEST(JoinStrokes, TheNearestEndsGoTogether) {
  // The end at 10 has two candidates; the nearer one leaves nothing else to join.
  const Polylines joined =
      join_near_ends(polylines_of({{{0, 0}, {10, 0}}, {{10.04, 0}, {20, 5}}, {{10, 0.01}, {20, -5}}}), 0.05);
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_EQ(joined[0].back(), Point2(20, -5));
}

TEST(JoinStrokes, AGapIsClosedOnlyByALineThatComesBack) {
  const Polylines closed = join_strokes(polylines_of({{{0, 0}, {10, 0}, {10, 10}, {0, 0.03}}}), {});
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(closed[0].front(), closed[0].back());
  const Polylines tiny = join_strokes(polylines_of({{{0, 0}, {0.04, 0}}}), {});
  ASSERT_EQ(tiny.size(), 1u);
  EXPECT_EQ(tiny[0].size(), 2u);
}

TEST(JoinStrokes, RingsAreTakenIntoWhatTheyTouch) {
  // A line with two triangles on it, and a third on one of them: one stroke.
  const Polylines joined = join_strokes(
      polylines_of(
          {{{0, 0}, {10, 0}}, {{10, 0}, {20, 0}}, {{10, 0}, {12, 5}, {8, 5}, {10, 0}}, {{8, 5}, {12, 9}, {4, 9}, {8, 5}}}),
      {});
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].front(), Point2(0, 0));
  EXPECT_EQ(joined[0].back(), Point2(20, 0));
}

TEST(JoinStrokes, AFigureTakesHalfAsManyStrokesAsItHasOddPoints) {
  // A grid of 6 x 6 cells: 20 points on the rim where three lines meet, 4 corners of two, the rest of four.
  std::vector<std::vector<Point2>> lists;
  for (int i = 0; i <= 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      lists.push_back({{j * 5.0, i * 5.0}, {j * 5.0 + 5, i * 5.0}});
      lists.push_back({{i * 5.0, j * 5.0}, {i * 5.0, j * 5.0 + 5}});
    }
  }
  const Polylines joined = join_strokes(polylines_of(lists), {});
  EXPECT_EQ(joined.size(), 10u);
  EXPECT_NEAR(total_length(joined), 2 * 7 * 30, 1e-4);
}

TEST(JoinStrokes, LinesTwiceAndLinesThatOverlapAreDrawnOnce) {
  std::vector<Point2> circle;
  for (int i = 0; i <= 3000; ++i)
    circle.push_back({50 + 30 * std::cos(i * 2 * M_PI / 3000), 50 + 30 * std::sin(i * 2 * M_PI / 3000)});
  std::vector<Point2> turned(circle.rbegin(), circle.rend());
  const Polylines joined =
      join_strokes(polylines_of({circle, turned, {{0, 0}, {10, 0}}, {{20, 0.001}, {5, 0.001}}, {{10, 0}, {0, 0}}}), {});
  EXPECT_EQ(joined.size(), 2u);
  EXPECT_NEAR(total_length(joined), 2 * M_PI * 30 + 20, 0.1);
}

TEST(JoinStrokes, FineCurvesTwiceAreDrawnOnce) {
  // Segments of 2 micrometres.
  std::vector<Point2> circle;
  for (int i = 0; i <= 9000; ++i)
    circle.push_back({50 + 3 * std::cos(i * 2 * M_PI / 9000), 50 + 3 * std::sin(i * 2 * M_PI / 9000)});
  const std::vector<Point2> turned(circle.rbegin(), circle.rend());
  const Polylines joined = join_strokes(polylines_of({circle, turned, circle}), {});
  EXPECT_EQ(joined.size(), 1u);
  // A thousandth of the length may be lost.
  EXPECT_NEAR(total_length(joined), 2 * M_PI * 3, 0.001 * 2 * M_PI * 3);
}

TEST(JoinStrokes, SmallCurvesTwiceAreDrawnOnceWhereverTheyBegin) {
  for (const double radius : {0.02, 0.05, 0.1, 0.125, 0.15, 0.25, 0.5, 1.5, 5.0}) {
    std::vector<Point2> one, other;
    for (int i = 0; i <= 90; ++i) {
      const double angle = i * 2 * M_PI / 90, turned = 1 - i * 2 * M_PI / 90;
      one.push_back({50 + radius * std::cos(angle), 50 + radius * std::sin(angle)});
      other.push_back({50 + radius * std::cos(turned), 50 + radius * std::sin(turned)});
    }
    const Polylines joined = join_strokes(polylines_of({one, other, one}), {});
    EXPECT_EQ(joined.size(), 1u) << radius;
    EXPECT_NEAR(total_length(joined), 2 * M_PI * radius, 0.002 * 2 * M_PI * radius) << radius;
    // Beside each other they are two.
    for (Point2& p : other) p.x += 0.025;
    EXPECT_GT(total_length(join_strokes(polylines_of({one, other}), {})), 1.8 * 2 * M_PI * radius) << radius;
  }
}

TEST(JoinStrokes, LinesApartByMoreThanATraceStayTwo) {
  // A pen of 0.35 mm would lose six percent of the ink.
  EXPECT_EQ(join_strokes(polylines_of({{{0, 0}, {30, 0}}, {{0, 0.018}, {30, 0.018}}}), {0.0}).size(), 2u);
}

TEST(JoinStrokes, DotsStayAndAreDrawnOnce) {
  const Polylines joined = join_strokes(polylines_of({{{5, 5}, {5, 5}}, {{0, 0}, {1, 0}}, {{5, 5}}}), {});
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_EQ(joined[1].size(), 2u);
  EXPECT_EQ(joined[1][0], joined[1][1]);
}

TEST(JoinStrokes, NothingIsNothing) {
  EXPECT_EQ(join_strokes({}, {}).size(), 0u);
  EXPECT_EQ(order_strokes({}, {}).size(), 0u);
}

Polylines circle(double radius_mm, int points) {
  std::vector<Point2> line;
  for (int i = 0; i < points; ++i)
    line.push_back({50 + radius_mm * std::cos(i * 2 * M_PI / points), 50 + radius_mm * std::sin(i * 2 * M_PI / points)});
  line.push_back(line.front());
  return polylines_of({line});
}

TEST(JoinStrokes, AShapeSmallerThanTheToleranceKeepsItsLength) {
  const Polylines given = circle(0.008, 64);
  const Polylines joined = join_strokes(given, {});
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_GE(total_length(joined), 0.999 * total_length(given) - 64 * 1e-6) << "but for rounding to the lattice";
}

TEST(EndTree, FindsWhatALookAtAllPointsFinds) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(0, 40);
  std::vector<Point2> points(500);
  for (Point2& p : points) p = {double(place(random)), double(place(random))};
  EndTree tree(points);
  std::vector<char> there(points.size(), 1);
  for (std::size_t removed = 0; removed < points.size(); ++removed) {
    const Point2 q{place(random) + 0.3, place(random) - 0.2};
    const std::uint32_t found = tree.nearest(q);
    double least = 1e300;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (there[i]) least = std::min(least, glm::distance(q, points[i]));
    }
    ASSERT_NE(found, EndTree::kNone);
    ASSERT_TRUE(there[found]);
    ASSERT_DOUBLE_EQ(glm::distance(q, points[found]), least);
    tree.remove(found);
    there[found] = 0;
  }
  EXPECT_EQ(tree.nearest({0, 0}), EndTree::kNone);
}

}  // namespace
}  // namespace ligne
