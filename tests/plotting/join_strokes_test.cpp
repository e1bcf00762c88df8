/// Joining strokes at their ends, and the search for near ends: known answers.

#include "geometry/nearest_on_segment.hpp"
#include "plotting/paths/chain_ends.hpp"
#include "plotting/paths/nearest_points.hpp"
#include "plotting/paths/simplify.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

using namespace test;

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

/// Turned round, in segments of 63 and of 2 micrometres; and small ones that begin elsewhere.
TEST(JoinStrokes, CurvesTwiceAreDrawnOnce) {
  struct Row {
    double radius;
    int points;
    double error;
  };
  for (const auto& [radius, points, error] : {Row{30, 3000, 0.0005}, Row{3, 9000, 0.001}, Row{0.25, 90, 0.002},
                                              Row{0.5, 90, 0.002}, Row{1.5, 90, 0.002}, Row{5, 90, 0.002}}) {
    const double length = 2 * M_PI * radius;
    const bool is_small = points == 90;
    const std::vector<Point2> one = circle_line(radius, points);
    std::vector<Point2> other;
    for (int i = 0; i <= points; ++i) {
      const double angle = is_small - i * 2 * M_PI / points;
      other.push_back({50 + radius * std::cos(angle), 50 + radius * std::sin(angle)});
    }
    const Polylines joined = join_strokes(polylines_of({one, other, one}), {});
    EXPECT_EQ(joined.size(), 1u) << radius;
    EXPECT_NEAR(total_length(joined), length, error * length) << radius;
    if (!is_small) continue;
    // Beside each other they are two, but for the quarter over which they lie within the tolerance.
    for (Point2& p : other) p.x += 0.025;
    EXPECT_GT(total_length(join_strokes(polylines_of({one, other}), {})), 1.72 * length) << radius;
  }
}

TEST(JoinStrokes, NothingIsNothing) {
  EXPECT_EQ(join_strokes({}, {}).size(), 0u);
  EXPECT_EQ(order_strokes({}, {}).size(), 0u);
}

TEST(JoinStrokes, AShapeSmallerThanTheToleranceKeepsItsLength) {
  const Polylines given = polylines_of({circle_line(0.008, 64)});
  const Polylines joined = join_strokes(given, {});
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_GE(total_length(joined), 0.999 * total_length(given) - 64 * 1e-6) << "but for rounding to the lattice";
}

/// Points with whole coordinates, of which many lie in one place.
std::vector<Point2> crowded_points(std::size_t count, int extent) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-extent, extent);
  std::vector<Point2> points(count);
  for (Point2& p : points) p = {double(place(random)), double(place(random))};
  return points;
}

/// In the order of distance, of those that remain.
TEST(NearestPoints, FindsTheNearestOfTheRemainingPoints) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-20, 20);
  const std::vector<Point2> points = crowded_points(500, 20);
  NearestPoints tree(points);
  std::vector<char> there(points.size(), 1);
  std::vector<NearestPoints::Neighbour> nearest;
  for (std::size_t removed = 0; removed < points.size(); ++removed) {
    const Point2 q{place(random) + 0.5, place(random) - 0.25};
    std::vector<double> expected;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (there[i]) expected.push_back(glm::dot(q - points[i], q - points[i]));
    std::sort(expected.begin(), expected.end());
    tree.nearest(q, 10, nearest);
    ASSERT_EQ(nearest.size(), std::min<std::size_t>(10, expected.size()));
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      ASSERT_TRUE(there[nearest[i].point]);
      ASSERT_EQ(nearest[i].squared, expected[i]);
    }
    tree.remove(nearest[0].point);
    there[nearest[0].point] = 0;
  }
  tree.nearest({0, 0}, 1, nearest);
  EXPECT_TRUE(nearest.empty());
}

/// Leaving out points of lines: known answers, and what a look at all points finds.

using Line = std::vector<Point2>;

TEST(Simplified, KeepsWhatTurnsAndDropsWhatDoesNot) {
  const std::vector<Point2> line{{0, 0}, {1, 0.01}, {2, 0}, {3, 0.5}, {4, 0}};
  EXPECT_EQ(simplified(line, 0.02), (std::vector<std::uint32_t>{0, 2, 3, 4}));
  EXPECT_EQ(simplified(line, 0), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  const std::vector<Point2> there_and_back{{0, 0}, {5, 0}, {1, 0}};
  EXPECT_EQ(simplified(there_and_back, 0.02).size(), 3u) << "the far point is no part of the segment";
}

TEST(Simplified, KeepsAsMuchOfTheLengthAsIsAsked) {
  for (const double radius : {0.005, 0.3, 3.0, 30.0}) {
    const Line given = circle_line(radius, 720);
    const std::vector<std::uint32_t> kept = simplified(given, 0.02, 0.001);
    double length = 0, before = 0;
    for (std::size_t k = 1; k < kept.size(); ++k) length += glm::distance(given[kept[k - 1]], given[kept[k]]);
    for (std::size_t k = 1; k < given.size(); ++k) before += glm::distance(given[k - 1], given[k]);
    EXPECT_GE(length, 0.999 * before) << radius;
    // Halves of halves, of which the first that are allowed: at most twice as many as needed.
    const double turn = std::min(std::sqrt(24 * 0.001), std::sqrt(8 * 0.02 / radius));
    EXPECT_LE(static_cast<double>(kept.size()), 2 * 2 * M_PI / turn + 1) << radius;
  }
}

/// The points of a star are near the middle and far from it by turns.
Line star(int points) {
  Line line = circle_line(40, points);
  for (std::size_t i = 0; i < line.size(); i += 2) line[i] = (line[i] + Point2{50, 50}) * 0.5;
  return line;
}

std::vector<std::pair<std::string, Line>> lines() {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> step(-9, 9), place(0, 12);
  std::vector<std::pair<std::string, Line>> all{
      {"circle", circle_line(30, 1500)}, {"star", star(1500)}, {"star of 4000", star(4000)}};
  Line comb, spiral, walk, crowd, there_and_back;
  for (int i = 0; i < 1200; ++i) {
    comb.push_back({(i / 2) * 0.25, (i % 4) / 2 * 64.0});
    spiral.push_back({i * std::cos(i * 0.05), i * std::sin(i * 0.05)});
    walk.push_back((i == 0 ? Point2{0, 0} : walk.back()) + Point2{step(random), step(random)} * 0.125);
    crowd.push_back({place(random), place(random)});
    there_and_back.push_back({i % 2 == 0 ? 0.0 : 1200.0 - i, 0.0});
  }
  all.emplace_back("comb", comb);
  all.emplace_back("spiral", spiral);
  all.emplace_back("walk", walk);
  all.emplace_back("points many times", crowd);
  all.emplace_back("there and back", there_and_back);
  all.emplace_back("in one place", Line(300, {1, 1}));
  for (std::size_t n = 2; n < 200; n += 31) all.emplace_back("beginning of a walk", Line(walk.begin(), walk.begin() + n));
  return all;
}

TEST(Simplified, KeepsTheLineWithinTheTolerance) {
  for (const auto& [name, line] : lines()) {
    for (const double tolerance : {0.0, 0.1, 3.0}) {
      const std::vector<std::uint32_t> kept = simplified(line, tolerance);
      ASSERT_EQ(kept.front(), 0u);
      ASSERT_EQ(kept.back(), line.size() - 1);
      for (std::size_t k = 1; k < kept.size(); ++k) {
        ASSERT_LT(kept[k - 1], kept[k]) << name;
        for (std::uint32_t i = kept[k - 1]; i < kept[k]; ++i)
          ASSERT_LE(squared_distance(line[i], line[kept[k - 1]], line[kept[k]]), tolerance * tolerance) << name;
      }
    }
  }
}

TEST(Simplified, KeepsOfAZigzagAllThatTurns) {
  const Line line = star(4000);
  EXPECT_EQ(simplified(line, 0.02).size(), line.size());
}

}  // namespace
}  // namespace ligne
