#include "geometry/predicates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ligne {
namespace {

void expect_identities(Point2 a, Point2 b, Point2 c) {
  const int sign = orientation_sign(a, b, c);
  EXPECT_EQ(sign, orientation_sign(b, c, a));
  EXPECT_EQ(sign, orientation_sign(c, a, b));
  EXPECT_EQ(sign, -orientation_sign(b, a, c));
  EXPECT_EQ(sign, -orientation_sign(a, c, b));
  EXPECT_EQ(sign, -orientation_sign(c, b, a));
}

TEST(OrientationSign, KnownTriangles) {
  EXPECT_EQ(orientation_sign({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orientation_sign({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orientation_sign({0, 0}, {1, 1}, {3, 3}), 0);
  EXPECT_EQ(orientation_sign({2, 5}, {2, 5}, {7, 1}), 0);
}

TEST(OrientationSign, IdentitiesOnNearlyCollinearPoints) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> step(-3, 3);
  for (int i = 0; i < 20000; ++i) {
    const auto near = [&](double v) { return v + step(random) * std::ldexp(1.0, -52); };
    expect_identities({near(0.5), near(0.5)}, {near(12), near(12)}, {near(24), near(24)});
  }
}

// Points (k + x u, k + y u) on a fine grid: the determinant is a whole number of steps and known without rounding.
TEST(OrientationSign, AgreesWithWholeNumberArithmetic) {
  std::mt19937_64 random(2);
  constexpr std::int64_t kSize = std::int64_t{1} << 52;
  std::uniform_int_distribution<std::int64_t> base(-kSize / 2, kSize / 2), nudge(-2, 2), factor(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t ax = base(random), ay = base(random), dx = base(random) / 2, dy = base(random) / 2;
    const std::int64_t bx = ax + dx, by = ay + dy;
    const std::int64_t f = factor(random);
    const std::int64_t cx = ax + f * dx + nudge(random), cy = ay + f * dy + nudge(random);
    const __int128 det = static_cast<__int128>(bx - ax) * (cy - ay) - static_cast<__int128>(by - ay) * (cx - ax);
    const auto point = [](std::int64_t x, std::int64_t y) { return Point2(double(x), double(y)); };
    const int sign = orientation_sign(point(ax, ay), point(bx, by), point(cx, cy));
    EXPECT_EQ(sign, det > 0 ? 1 : det < 0 ? -1 : 0);
  }
}

TEST(OrientationSign, SeesOneUnitInTheLastPlace) {
  const double x = std::nextafter(0.5, 1);
  EXPECT_EQ(orientation_sign({0, 0}, {1e10, 1e10}, {0.5, x}), 1);
  EXPECT_EQ(orientation_sign({0, 0}, {1e10, 1e10}, {x, 0.5}), -1);
  EXPECT_EQ(orientation_sign({0, 0}, {1e10, 1e10}, {x, x}), 0);
}

}  // namespace
}  // namespace ligne
