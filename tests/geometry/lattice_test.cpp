#include "geometry/lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace ligne {
namespace {

Rect rect(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y1}}; }

TEST(Lattice, StepIsAPowerOfTwoAndTheFinestThatFits) {
  for (const Rect& page : {rect(0, 0, 297, 210), rect(0, 0, 1189, 841), rect(0, 0, 1, 1e-3), rect(-5e3, 2, 7e4, 3)}) {
    const Lattice lattice = Lattice::covering(page);
    int exponent = 0;
    EXPECT_EQ(std::frexp(lattice.step_mm, &exponent), 0.5);
    const double half = std::max(page.width(), page.height()) / 2;
    EXPECT_LE(half / lattice.step_mm, kLatticeLimit);
    EXPECT_GT(half / (lattice.step_mm / 2), kLatticeLimit - 2);
  }
}

TEST(Lattice, IsFarBelowAMicrometreUpToA0) {
  EXPECT_LE(Lattice::covering(rect(0, 0, 297, 210)).step_mm, 8e-6);
  EXPECT_LE(Lattice::covering(rect(0, 0, 1189, 841)).step_mm, 4e-5);
}

TEST(Lattice, CornersStayInsideTheLimitAndComeBack) {
  const Rect page = rect(-3.7, 12.1, 1185.3, 853.1);
  const Lattice lattice = Lattice::covering(page);
  for (const Point2 p : {page.min, page.max, Point2(page.min.x, page.max.y), Point2(page.max.x, page.min.y)}) {
    const LatticePoint q = lattice.snap(p);
    EXPECT_LT(std::abs(q.x), kLatticeLimit);
    EXPECT_LT(std::abs(q.y), kLatticeLimit);
    EXPECT_LE(std::abs(lattice.to_mm(q).x - p.x), lattice.step_mm / 2);
    EXPECT_LE(std::abs(lattice.to_mm(q).y - p.y), lattice.step_mm / 2);
  }
}

TEST(Lattice, SnappingALatticePointChangesNothing) {
  const Lattice lattice = Lattice::covering(rect(0, 0, 297, 210));
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int32_t> coordinate(-kLatticeLimit, kLatticeLimit);
  for (int i = 0; i < 1000; ++i) {
    const LatticePoint p{coordinate(random), coordinate(random)};
    EXPECT_EQ(lattice.snap(lattice.to_mm(p)), p);
  }
}

TEST(Lattice, FarPointsAreClampedToTheLimit) {
  const Lattice lattice = Lattice::covering(rect(0, 0, 297, 210));
  EXPECT_EQ(lattice.snap({1e30, -1e30}), (LatticePoint{kLatticeLimit, -kLatticeLimit}));
}

TEST(Lattice, PagesWithoutAreaAreWelcome) {
  const Lattice line = Lattice::covering(rect(10, 5, 90, 5));
  EXPECT_EQ(line.to_mm(line.snap({10, 5})), Point2(10, 5));
  const Lattice point = Lattice::covering(rect(7, 7, 7, 7));
  EXPECT_NEAR(point.to_mm(point.snap({7, 7})).x, 7, 1e-9);
  EXPECT_EQ(Lattice::covering(Rect{}).step_mm, 1);
}

TEST(LatticeOrientation, IdentitiesAndExactnessAtTheLimit) {
  std::mt19937 random(4);
  std::uniform_int_distribution<std::int32_t> coordinate(-kLatticeLimit, kLatticeLimit);
  for (int i = 0; i < 10000; ++i) {
    const auto draw = [&] { return LatticePoint{coordinate(random), coordinate(random)}; };
    const LatticePoint a = draw(), b = draw(), c = draw();
    const std::int64_t exact =
        (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
    EXPECT_EQ(orientation(a, b, c), static_cast<double>(exact));
    EXPECT_EQ(orientation(a, b, c), orientation(b, c, a));
    EXPECT_EQ(orientation(a, b, c), -orientation(b, a, c));
    EXPECT_EQ(orientation(a, a, c), 0);
  }
}

}  // namespace
}  // namespace ligne
