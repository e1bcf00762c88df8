#include "drawing/stroke_difference.hpp"

#include <gtest/gtest.h>

#include "stroke_builder.hpp"

namespace ligne {
namespace {

/// A tolerance of half a step of these lattices, which are a millimetre wide.
constexpr double kHalf = 0.5;

TEST(StrokeDifference, NoneBetweenTheSameLineInOtherPieces) {
  const StrokeModel whole = model({stroke({0, 0}, {90, 30})});
  const StrokeModel pieces = model({stroke({30, 10}, {0, 0}), stroke({30, 10}, {90, 30})});
  EXPECT_EQ(difference_of(whole, pieces, kHalf).length_mm, 0);
}

TEST(StrokeDifference, IsWhatOneOfThemLacks) {
  const StrokeModel first = model({stroke({0, 0}, {100, 0}), stroke({0, 50}, {100, 50})});
  const StrokeModel second = model({stroke({0, 0}, {40, 0}), stroke({70, 0}, {100, 0}), stroke({0, 50}, {120, 50})});
  const StrokeDifference d = difference_of(first, second, kHalf);
  ASSERT_EQ(d.only_first.size(), 1u);
  EXPECT_NEAR(d.only_first[0].from.x, 40, 1e-9);
  EXPECT_NEAR(d.only_first[0].to.x, 70, 1e-9);
  ASSERT_EQ(d.only_second.size(), 1u);
  EXPECT_NEAR(d.length_mm, 50, 1e-9);
  EXPECT_NEAR(d.longest_mm, 30, 1e-9);
}

TEST(StrokeDifference, HiddenStrokesAreNotDrawn) {
  const StrokeModel seen = model({stroke({0, 0}, {100, 0})});
  const StrokeModel unseen = model({hidden(stroke({0, 0}, {100, 0}))});
  EXPECT_NEAR(difference_of(seen, unseen, kHalf).length_mm, 100, 1e-9);
  EXPECT_EQ(difference_of(unseen, unseen, kHalf).length_mm, 0);
}

TEST(StrokeDifference, LevelsCountWhereTheyAreAskedFor) {
  StrokeModel direct = model({stroke({0, 0}, {100, 0})}), through = direct;
  through.strokes[0].level = 1;
  EXPECT_TRUE(parts_missing(direct, through, kHalf).empty());
  EXPECT_EQ(parts_missing(direct, through, kHalf, true).size(), 1u);
}

TEST(StrokeDifference, TheSameStrokesBackToFront) {
  const StrokeModel there = model({stroke({0, 0}, {100, 30}), stroke({20, 0}, {20, 50})});
  const StrokeModel back = model({stroke({20, 50}, {20, 0}), stroke({100, 30}, {0, 0})});
  EXPECT_EQ(difference_of(there, back, kHalf).length_mm, 0);
}

TEST(StrokeDifference, TheSamePointsOfAnotherLatticeAreElsewhere) {
  const StrokeModel here = model({stroke({0, 0}, {100, 0})});
  StrokeModel elsewhere = here;
  elsewhere.lattice.origin_mm.y += 10;
  EXPECT_NEAR(difference_of(here, elsewhere, kHalf).length_mm, 200, 1e-9);
}

}  // namespace
}  // namespace ligne
