#include <gtest/gtest.h>

#include "drawing/stroke_overlap.hpp"

namespace ligne {
namespace {

constexpr double kOverlapTolerance = 10;

std::optional<StrokeOverlap> test(LatticePoint a0, LatticePoint a1, LatticePoint b0, LatticePoint b1) {
  return overlap(a0, a1, b0, b1, kOverlapTolerance);
}

TEST(StrokeOverlap, PartOfTheOther) {
  const auto o = test({0, 0}, {1000, 0}, {250, 0}, {500, 0});
  ASSERT_TRUE(o);
  EXPECT_EQ(o->a_from, 0.25);
  EXPECT_EQ(o->a_to, 0.5);
  EXPECT_EQ(o->b_from, 0);
  EXPECT_EQ(o->b_to, 1);
}

TEST(StrokeOverlap, RunsTheOtherWay) {
  const auto o = test({500, 0}, {250, 0}, {0, 0}, {1000, 0});
  ASSERT_TRUE(o);
  EXPECT_EQ(o->a_from, 0);
  EXPECT_EQ(o->a_to, 1);
  EXPECT_EQ(o->b_from, 0.5);
  EXPECT_EQ(o->b_to, 0.25);
}

TEST(StrokeOverlap, PartsOfBoth) {
  const auto o = test({0, 0}, {0, 1000}, {0, 1500}, {0, 500});
  ASSERT_TRUE(o);
  EXPECT_EQ(o->a_from, 0.5);
  EXPECT_EQ(o->a_to, 1);
  EXPECT_EQ(o->b_from, 1);
  EXPECT_EQ(o->b_to, 0.5);
}

TEST(StrokeOverlap, NotLongerThanTheTolerance) {
  EXPECT_FALSE(test({0, 0}, {1000, 0}, {990, 0}, {2000, 0}));
  EXPECT_TRUE(test({0, 0}, {1000, 0}, {989, 0}, {2000, 0}));
  EXPECT_FALSE(test({0, 0}, {1000, 0}, {1000, 0}, {2000, 0})) << "end to end";
  EXPECT_FALSE(test({0, 0}, {10, 0}, {0, 0}, {10, 0})) << "as short as the tolerance";
}

TEST(StrokeOverlap, DeviationUpToTheTolerance) {
  EXPECT_TRUE(test({0, 0}, {1000, 0}, {0, 10}, {900, -10}));
  EXPECT_FALSE(test({0, 0}, {1000, 0}, {0, 11}, {900, 11}));
}

TEST(StrokeOverlap, AWedgeDoesNotCoincide) {
  EXPECT_FALSE(test({0, 0}, {100000, 0}, {0, 0}, {100000, 11}));
  EXPECT_FALSE(test({0, 0}, {100000, 0}, {0, 0}, {50000, 11}));
  EXPECT_TRUE(test({0, 0}, {100000, 0}, {0, 0}, {50000, 10})) << "closes again within the tolerance";
  EXPECT_FALSE(test({0, 0}, {1000, 0}, {500, -300}, {500, 300})) << "crossing";
}

}  // namespace
}  // namespace ligne
