#include "geometry/degrees.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ligne::test {
namespace {

TEST(Degrees, WholeQuartersAreExact) {
  const double sines[] = {0, 1, 0, -1};
  for (int quarters = -9; quarters <= 9; ++quarters) {
    const SineCosine at = sine_cosine_degrees(90.0 * quarters);
    EXPECT_EQ(at.sine, sines[quarters & 3]) << quarters;
    EXPECT_EQ(at.cosine, sines[(quarters + 1) & 3]) << quarters;
  }
}

TEST(Degrees, OthersAreThoseOfRadians) {
  for (double degrees = -400; degrees <= 400; degrees += 7.3) {
    const SineCosine at = sine_cosine_degrees(degrees), opposite = sine_cosine_degrees(-degrees);
    EXPECT_NEAR(at.sine, std::sin(degrees * std::acos(-1.0) / 180), 1e-14) << degrees;
    EXPECT_NEAR(at.cosine, std::cos(degrees * std::acos(-1.0) / 180), 1e-14) << degrees;
    EXPECT_EQ(opposite.sine, -at.sine) << degrees;
    EXPECT_EQ(opposite.cosine, at.cosine) << degrees;
  }
}

TEST(Degrees, NoAngleHasNone) {
  EXPECT_TRUE(std::isnan(sine_cosine_degrees(HUGE_VAL).sine));
  EXPECT_TRUE(std::isnan(sine_cosine_degrees(std::nan("")).cosine));
}

}  // namespace
}  // namespace ligne::test
