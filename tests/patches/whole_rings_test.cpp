/// Creases of free forms: whole rings of rims, rims of bevels, and nothing inside roundings.

#include "patches/found_creases.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

/// A coarse bevel: two wide sides at an angle of 110 degrees, with four narrow strips between them. It bends along the five
/// rulings, most along the middle one: by middle_degrees(y) there, and evenly along the others. At y = 0 a wall closes it,
/// at an angle of 90 degrees.
std::vector<Corners> bevel(const std::function<double(double)>& middle_degrees) {
  constexpr int kLength = 24, kRulings = 5;
  constexpr double kTotalDegrees = 110, kSide = 12, kStrip = 2;
  const auto profile = [&](int y) {
    std::vector<Point3> points{{-kSide, y, 0}, {0, y, 0}};
    double direction = 0;  // degrees
    for (int k = 0; k < kRulings; ++k) {
      direction += k == kRulings / 2 ? middle_degrees(y) : (kTotalDegrees - middle_degrees(y)) / (kRulings - 1);
      const double width = k + 1 == kRulings ? kSide : kStrip, angle = direction * kPi / 180;
      points.push_back(points.back() + width * Point3(std::cos(angle), 0, -std::sin(angle)));
    }
    return points;
  };
  std::vector<Corners> polygons;
  add_grid(polygons, kRulings + 1, kLength, true, [&](int k, int y) { return profile(y)[static_cast<std::size_t>(k)]; });
  Corners wall = profile(0);
  wall.push_back({-kSide, 0, wall.back().z});
  polygons.push_back(wall);
  return polygons;
}

/// The length of the creases along the middle ruling of a bevel, which lies between these places on the x axis.
double middle_crease(const FoundCreases& found) {
  constexpr double kLow = 3, kHigh = 3.7;
  double length = 0;
  for (std::size_t e = 0; e < found.topology.edges.size(); ++e) {
    const Point3 &a = found.end(e, false), &b = found.end(e, true);
    const bool is_on_ruling = a.y != b.y && std::min(a.x, b.x) > kLow && std::max(a.x, b.x) < kHigh;
    if (is_on_ruling && found.is_crease(e)) length += glm::distance(a, b);
  }
  return length;
}

TEST(WholeRings, OfABevelKeepARimThatLeadsToAnotherCrease) {
  // The rim begins at the wall, and fades halfway.
  const FoundCreases found(bevel([](double y) { return 44 - y; }));
  EXPECT_NEAR(middle_crease(found), 12, 1.5);
}

TEST(WholeRings, OfABevelHaveNoLineThatMeetsNoOther) {
  const FoundCreases found(bevel([](double y) { return 42 - (y - 12) * (y - 12) / 4; }));
  EXPECT_EQ(middle_crease(found), 0);
}

}  // namespace
}  // namespace ligne::test
