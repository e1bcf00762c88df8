/// Lines along the middle of fillets.

#include "scene/patches/fillets.hpp"
#include "support/test.hpp"

#include "patches/patch_scenes.hpp"

namespace ligne {
namespace {

using namespace test;

double length_of(const FaceLine& line) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) sum += glm::distance(line.points[i], line.points[i + 1]);
  return sum;
}

class RoundedBoxes : public testing::TestWithParam<int> {};

TEST_P(RoundedBoxes, NarrowFilletsHaveTwelveLinesThatMeetAtTheCorners) {
  const FoundPatches found(rounded_box({8, 6, 4}, GetParam()));
  const FilletMiddles middles = fillet_middles(found.scene, found.topology, found.patches, found.edges, 2);
  double length = 0;
  std::size_t straight = 0;
  for (const FaceLine& line : middles.lines) {
    ASSERT_EQ(line.points.size(), line.faces.size() + 1);
    length += length_of(line);
    const double chord = glm::distance(line.points.front(), line.points.back());
    straight += length_of(line) < chord * (1 + 1e-5) && chord > 5;
    // Every point lies on the mesh, which is no farther from the box of the fillets' middles than its sag.
    for (const Point3& p : line.points) {
      const Point3 out = glm::max(glm::abs(p) - Point3(7, 5, 3), Point3(0, 0, 0));
      EXPECT_NEAR(glm::length(out), 1, 0.07);
    }
  }
  EXPECT_EQ(straight, 12u);
  // Twelve lines along the fillets, and in each corner three arcs from the middle of a side to that of the corner.
  const double arc = std::acos(std::sqrt(2.0 / 3));
  EXPECT_NEAR(length, 4 * (14 + 10 + 6) + 24 * arc, 0.6);
}

TEST_P(RoundedBoxes, WideFilletsHaveNone) {
  const FoundPatches found(rounded_box({8, 6, 4}, GetParam()));
  const FilletMiddles middles = fillet_middles(found.scene, found.topology, found.patches, found.edges, 1);
  EXPECT_TRUE(middles.lines.empty());
  EXPECT_EQ(std::count(middles.is_fillet.begin(), middles.is_fillet.end(), 1), 0);
}

INSTANTIATE_TEST_SUITE_P(Steps, RoundedBoxes, testing::Values(3, 4, 6, 12));

TEST(Fillets, TheRoundingOfARimHasOneClosedLine) {
  // A disc whose rim goes over into a cylinder by a quarter of a torus.
  std::vector<Corners> polygons;
  const int sides = 48, steps = 6;
  add_grid(polygons, sides, steps, false, [&](int u, int v) {
    const double a = 2 * kPi * (u % sides) / sides, b = kPi / 2 * v / steps;
    return on_circle(9 + std::cos(b), a, std::sin(b));
  });
  add_grid(polygons, sides, 1, false,
           [&](int u, int v) { return on_circle(10, 2 * kPi * (u % sides) / sides, 5.0 * (v - 1)); });
  Corners top;
  for (int i = 0; i < sides; ++i) top.push_back(on_circle(9, 2 * kPi * i / sides, 1));
  polygons.push_back(top);
  const FoundPatches found(outward(polygons));
  const FilletMiddles middles = fillet_middles(found.scene, found.topology, found.patches, found.edges, 2);
  ASSERT_EQ(middles.lines.size(), 1u);
  EXPECT_TRUE(middles.lines[0].closed);
  EXPECT_NEAR(length_of(middles.lines[0]), 2 * kPi * (9 + std::sqrt(0.5)), 0.3);
}

}  // namespace
}  // namespace ligne
