// Rounding of depths to float.

#include "visibility/common/facet.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace ligne {
namespace {

void expect_rounded(double v) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float nearest = static_cast<float>(v);
  const float down = double(nearest) > v ? std::nextafter(nearest, -kInfinity) : nearest;
  const float up = double(nearest) < v ? std::nextafter(nearest, kInfinity) : nearest;
  EXPECT_EQ(std::bit_cast<std::uint32_t>(round_down(v)), std::bit_cast<std::uint32_t>(down)) << v;
  EXPECT_EQ(std::bit_cast<std::uint32_t>(round_up(v)), std::bit_cast<std::uint32_t>(up)) << v;
}

TEST(Facet, DepthsAreRoundedOutwards) {
  for (const double v : {0.0, 1.0, 1.1, 1e-40, 1e-50, 1.4e-45, 3.5e38, 1e300, 0x1p-126, 0x1.fffffffp-127}) {
    expect_rounded(v);
    expect_rounded(-v);
  }
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> exponent(-50, 40);
  for (int i = 0; i < 20'000; ++i) expect_rounded((i % 2 ? 1 : -1) * std::pow(10, exponent(random)));
}

}  // namespace
}  // namespace ligne
