// The elementary operation: what one facet hides of one line.

#include <gtest/gtest.h>

#include <array>

#include "visibility/common/hidden_interval.hpp"

namespace ligne::test {
namespace {

/// A facet 100 steps wide at depth 0 that touches whatever is less than 1 behind it.
constexpr std::array<ProjectedVertex, 3> kCorners{ProjectedVertex{{0, -100}, 0}, {{100, 0}, 0}, {{0, 100}, 0}};
constexpr Facet kFacet{{0, 1, 2}, 7, 0, 0, 1, 200};

HiddenInterval hidden(const PageLine& line, double from, double to) {
  bool near_side = false;
  return hidden_interval(line, kFacet, kCorners.data(), from, to, 0, near_side);
}

PageLine line_of_depths(double z0, double z1) { return {{{0, 0}, z0}, {{100, 0}, z1}, kNone, kNone}; }

TEST(HiddenInterval, OfALineInPiecesIsThatOfTheLine) {
  // Touching at both ends; behind at the far end, touching at the near one; passing through.
  for (const auto& [z0, z1] : {std::pair(0.25, 0.75), std::pair(0.0, 2.0), std::pair(2.0, 0.0), std::pair(-3.0, 1.5)}) {
    const PageLine line = line_of_depths(z0, z1);
    const HiddenInterval whole = hidden(line, 0, 1);
    for (const double middle : {0.125, 0.5, 0.875}) {
      for (const auto& [from, to] : {std::pair(0.0, middle), std::pair(middle, 1.0)}) {
        const HiddenInterval piece = hidden(line, from, to);
        const double expected_from = std::max(from, whole.from), expected_to = std::min(to, whole.to);
        if (whole.sides == HiddenSides::none || expected_from >= expected_to) {
          EXPECT_EQ(piece.sides, HiddenSides::none) << z0 << ' ' << z1 << ' ' << from << ' ' << to;
          continue;
        }
        EXPECT_EQ(piece.sides, whole.sides) << z0 << ' ' << z1 << ' ' << from << ' ' << to;
        EXPECT_EQ(piece.from, expected_from);
        EXPECT_EQ(piece.to, expected_to);
      }
    }
  }
}

TEST(HiddenInterval, ReachesWhereTheLineTouches) {
  const HiddenInterval i = hidden(line_of_depths(0, 2), 0, 1);
  EXPECT_EQ(i.sides, HiddenSides::both);
  EXPECT_EQ(i.from, 0);
  EXPECT_EQ(i.to, 1);
}

TEST(HiddenInterval, IsNoneWhereTheLineTouchesAllAlong) {
  EXPECT_EQ(hidden(line_of_depths(0.25, 0.75), 0, 1).sides, HiddenSides::none);
}

TEST(HiddenInterval, BeginsWhereTheLinePassesThrough) {
  const HiddenInterval i = hidden(line_of_depths(-2, 2), 0, 1);
  EXPECT_EQ(i.from, 0.5);
  EXPECT_EQ(i.to, 1);
}

}  // namespace
}  // namespace ligne::test
