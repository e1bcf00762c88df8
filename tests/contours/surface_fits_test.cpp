// Surfaces through the vertices round a point.

#include "contours/surface_fits.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace ligne::test {
namespace {

using Height = std::function<double(double x, double y)>;

/// Two rings of six and twelve points round the origin, unevenly, at heights over the plane.
std::vector<Point3> rings(double size, const Height& height) {
  std::mt19937 random(5);
  const auto unit = [&] { return double(random()) / double(std::mt19937::max()) - 0.5; };
  std::vector<Point3> points;
  for (int ring = 1; ring <= 2; ++ring) {
    for (int i = 0; i < 6 * ring; ++i) {
      const double angle = (i + 0.5 * unit()) / (6 * ring) * 2 * 3.14159265358979323846;
      const double radius = size * (ring + 0.5 * unit());
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      points.push_back({x, y, height(x, y)});
    }
  }
  return points;
}

const Point3 kUp{0, 0, 1};

TEST(SurfaceFits, KnowsPolynomialsOfDegreeThree) {
  const Height height = [](double x, double y) {
    return 0.02 * x - 0.03 * y + 0.1 * x * x + 0.05 * x * y - 0.07 * y * y + 0.01 * x * x * x - 0.02 * x * y * y;
  };
  SurfaceFit fit;
  ASSERT_TRUE(fit_surface({0, 0, 0}, kUp, rings(0.5, height), fit));
  EXPECT_LT(glm::distance(fit.normal, glm::normalize(Point3{-0.02, 0.03, 1})), 1e-12);
  // A way along the surface, and the normal at its end.
  constexpr double kStep = 1e-6;
  const Point3 end = glm::normalize(Point3{-0.02 - 0.2 * kStep, 0.03 - 0.05 * kStep, 1});
  EXPECT_LT(glm::distance(ligne::turned(fit.turn, {kStep, 0, 0.02 * kStep}), end - fit.normal), 1e-5 * kStep);
}

TEST(SurfaceFits, NormalsComeNearerWithTheThirdPowerOfTheDistance) {
  // An ellipsoid beside its top, whose curvature changes.
  const Height surface = [](double x, double y) { return 5 * std::sqrt(1 - x * x / 36 - y * y / 16); };
  constexpr double kX = 1.5, kY = 1;
  const auto error = [&](double size) {
    const double top = surface(kX, kY);
    const Height height = [&](double x, double y) { return surface(kX + x, kY + y) - top; };
    SurfaceFit fit;
    EXPECT_TRUE(fit_surface({0, 0, 0}, glm::normalize(Point3{0.2, 0.3, 1}), rings(size, height), fit));
    return glm::distance(fit.normal, glm::normalize(Point3{kX / 36, kY / 16, top / 25}));
  };
  const double at_whole = error(0.4), at_half = error(0.2);
  EXPECT_LT(at_whole, 1e-3);
  EXPECT_LT(at_half, at_whole / 6);
}

TEST(SurfaceFits, RefuseWhatIsNoSurfaceOfDegreeThree) {
  SurfaceFit fit;
  std::mt19937 random(3);
  const Height noise = [&](double, double) { return 0.1 * double(random()) / double(std::mt19937::max()); };
  EXPECT_FALSE(fit_surface({0, 0, 0.05}, kUp, rings(1, noise), fit)) << "noise";
  const Height rounding = [](double x, double) { return x < 0.5 ? 0 : -0.3 * (x - 0.5); };
  EXPECT_FALSE(fit_surface({0, 0, 0}, kUp, rings(1, rounding), fit)) << "a flat side with a chamfer";
  const Height ball = [](double x, double y) { return std::sqrt(9 - x * x - y * y) - 3; };
  EXPECT_FALSE(fit_surface({0, 0, 0}, kUp, rings(1, ball), fit)) << "coarse";
  EXPECT_TRUE(fit_surface({0, 0, 0}, kUp, rings(0.25, ball), fit)) << "fine";
  std::vector<Point3> rows;
  for (int i = -4; i <= 4; ++i) {
    for (const double y : {0.0, 30.0}) {
      if (i != 0 || y > 0) rows.push_back({std::sin(0.1 * i), y, std::cos(0.1 * i) - 1});
    }
  }
  EXPECT_FALSE(fit_surface({0, 0, 0}, kUp, rows, fit)) << "two rows";
  EXPECT_FALSE(fit_surface({0, 0, 0}, kUp, std::vector<Point3>(20, Point3{0, 0, 0}), fit)) << "one place";
}

/// The places of the second have other numbers of points, too few for a cubic, and for any surface.
TEST(SurfaceFits, OfTwoPlacesAreThoseOfEachAlone) {
  const Height saddle = [](double x, double y) { return 0.05 * x * x - 0.08 * x * y + 0.01 * x; };
  const Height ball = [](double x, double y) { return std::sqrt(100 - x * x - y * y) - 10; };
  const std::vector<Point3> many = rings(0.5, saddle);
  for (const std::size_t count : {18, 10, 5, 0}) {
    std::vector<Point3> few = rings(0.7, ball);
    few.resize(count);
    const PointsRound a{{0, 0, 0}, kUp, many}, b{{0, 0, 0}, glm::normalize(Point3{0.1, 0, 1}), few};
    const auto both = fit_two_surfaces({a, b}), turned = fit_two_surfaces({b, a});
    for (const auto& [round, fits] : {std::pair{a, std::array{both[0], turned[1]}}, {b, std::array{both[1], turned[0]}}}) {
      SurfaceFit alone;
      const bool known = fit_surface(round.at, round.normal, round.points, alone);
      for (const auto& fit : fits) {
        ASSERT_EQ(fit.has_value(), known) << count << " points";
        if (!known) continue;
        EXPECT_EQ(fit->normal, alone.normal);
        EXPECT_EQ(fit->turn, alone.turn);
      }
    }
    EXPECT_TRUE(both[0]);
    EXPECT_EQ(both[1].has_value(), count >= 10);
  }
}

}  // namespace
}  // namespace ligne::test
