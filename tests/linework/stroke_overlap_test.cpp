#include "linework/overlaps/stroke_overlap.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

constexpr double kOverlapTolerance = 10;

std::optional<StrokeOverlap> test(LatticePoint a0, LatticePoint a1, LatticePoint b0, LatticePoint b1) {
  return overlap(a0, a1, b0, b1, kOverlapTolerance);
}

TEST(StrokeOverlap, IsPartOfBoth) {
  const struct {
    const char* name;
    LatticePoint a0, a1, b0, b1;
    std::array<double, 4> parts;
  } cases[] = {{"part of the other", {0, 0}, {1000, 0}, {250, 0}, {500, 0}, {0.25, 0.5, 0, 1}},
               {"runs the other way", {500, 0}, {250, 0}, {0, 0}, {1000, 0}, {0, 1, 0.5, 0.25}},
               {"parts of both", {0, 0}, {0, 1000}, {0, 1500}, {0, 500}, {0.5, 1, 1, 0.5}}};
  for (const auto& c : cases) {
    const auto o = test(c.a0, c.a1, c.b0, c.b1);
    ASSERT_TRUE(o) << c.name;
    EXPECT_EQ((std::array{o->a_from, o->a_to, o->b_from, o->b_to}), c.parts) << c.name;
  }
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

TEST(StrokeOverlap, LongSegmentsInOtherDirectionsDoNotCoincide) {
  // At this angle, they share about 2 tolerances divided by the slope.
  EXPECT_FALSE(test({0, 0}, {100000, 0}, {99800, -9}, {199800, 9991}));
  EXPECT_TRUE(test({0, 0}, {100000, 0}, {99800, -9}, {199800, 4991}));
  EXPECT_TRUE(test({0, 0}, {100000, 0}, {99800, -10}, {100000, 10})) << "one is short";
}

}  // namespace
}  // namespace ligne
