/// Leaving out points of lines: known answers, and what a look at all points finds.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "geometry/parallel.hpp"
#include "plotting/paths/farthest_point.hpp"
#include "plotting/paths/segment_distance.hpp"
#include "plotting/paths/simplify.hpp"

namespace ligne {
namespace {

using Line = std::vector<Point2>;

Line circle_line(double radius_mm, int points) {
  Line line;
  for (int i = 0; i < points; ++i)
    line.push_back({50 + radius_mm * std::cos(i * 2 * M_PI / points), 50 + radius_mm * std::sin(i * 2 * M_PI / points)});
  line.push_back(line.front());
  return line;
}

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

/// Of the squared distance of a point on the segment: coordinates are below 2^11, and a dozen roundings move them.
constexpr double kSquaredRounding = 0x1p-38 * 0x1p-38;

TEST(FarthestPoint, IsAsFarAsALookAtAllPointsFinds) {
  for (const auto& [name, line] : lines()) {
    const FarthestPoint tree(line);
    std::mt19937 random(5);
    std::uniform_int_distribution<std::uint32_t> any(0, static_cast<std::uint32_t>(line.size()) - 1);
    for (int k = 0; k < 300; ++k) {
      std::uint32_t from = any(random), to = any(random);
      if (k == 0) from = 0, to = static_cast<std::uint32_t>(line.size()) - 1;
      if (from > to) std::swap(from, to);
      double farthest = -1;
      for (std::uint32_t i = from + 1; i < to; ++i)
        farthest = std::max(farthest, squared_distance(line[i], line[from], line[to]));
      const FarthestPoint::Found found = tree.between(from, to);
      const double rounding = 0x1p-47 * std::max(farthest, 0.0) + kSquaredRounding;
      ASSERT_NEAR(found.squared_distance, farthest, rounding) << name << ", " << from << " to " << to;
      if (to <= from + 1) {
        ASSERT_EQ(found.at, from);
        continue;
      }
      ASSERT_TRUE(from < found.at && found.at < to) << name;
      ASSERT_EQ(squared_distance(line[found.at], line[from], line[to]), found.squared_distance) << name;
    }
  }
}

TEST(Simplified, KeepsTheLineWithinTheToleranceForAnyNumberOfThreads) {
  for (const auto& [name, line] : lines()) {
    for (const double tolerance : {0.0, 0.1, 3.0}) {
      std::vector<std::uint32_t> kept;
      run_with_threads(1, [&] { kept = simplified(line, tolerance); });
      ASSERT_EQ(kept.front(), 0u);
      ASSERT_EQ(kept.back(), line.size() - 1);
      for (std::size_t k = 1; k < kept.size(); ++k) {
        ASSERT_LT(kept[k - 1], kept[k]) << name;
        for (std::uint32_t i = kept[k - 1]; i < kept[k]; ++i) {
          ASSERT_LE(squared_distance(line[i], line[kept[k - 1]], line[kept[k]]), tolerance * tolerance) << name;
        }
      }
      std::vector<std::uint32_t> by_threads;
      run_with_threads(4, [&] { by_threads = simplified(line, tolerance); });
      ASSERT_EQ(kept, by_threads) << name;
    }
  }
}

TEST(Simplified, KeepsOfAZigzagAllThatTurns) {
  const Line line = star(4000);
  EXPECT_EQ(simplified(line, 0.02).size(), line.size());
}

}  // namespace
}  // namespace ligne
