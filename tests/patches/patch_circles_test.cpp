/// The circles at which surfaces end.

#include "scene/patches/patch_circles.hpp"
#include "patches/part_scenes.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

std::vector<PatchCircle> circles_of(const std::vector<Corners>& polygons) {
  const FoundPatches found(scene_of(polygons));
  return patch_circles(found.scene, found.topology, found.patches);
}

TEST(PatchCircles, AreThoseOfBothEndsOfEachBore) {
  const std::vector<PatchCircle> circles = circles_of(bored_plate(3, 4.5));
  ASSERT_EQ(circles.size(), std::size_t{4});
  for (const bool right : {false, true}) {
    for (const double z : {0.0, 5.0}) {
      const Point3 centre(right ? 30 : 10, 10, z);
      const auto circle =
          std::ranges::find_if(circles, [&](const PatchCircle& c) { return glm::distance(c.centre, centre) < 1e-4; });
      ASSERT_NE(circle, circles.end());
      EXPECT_NEAR(circle->radius, right ? 4.5 : 3, 1e-5);
      EXPECT_NEAR(std::abs(circle->axis.z), 1, 1e-6);
    }
  }
}

TEST(PatchCircles, OfATurnedBodyHaveOneForEachEdgeOfItsProfile) {
  // A cylinder, a cone, and a cylinder again: both sides of an edge have its circle, in the same place.
  const std::vector<PatchCircle> circles = circles_of(turned_body(kTurnedFacets, {{20, 0}, {20, 10}, {12, 16}, {12, 30}}));
  std::map<long, std::size_t> at;  // per height: number of circles
  for (const PatchCircle& circle : circles) {
    ++at[std::lround(circle.centre.z)];
    EXPECT_NEAR(circle.radius, circle.centre.z < 12 ? 20 : 12, 1e-4);
  }
  EXPECT_EQ(at, (std::map<long, std::size_t>{{0, 1}, {10, 2}, {16, 2}, {30, 1}}));
}

TEST(PatchCircles, APrismHasNone) { EXPECT_TRUE(circles_of(turned_body(8, {{20, 0}, {20, 10}})).empty()); }

}  // namespace
}  // namespace ligne::test
