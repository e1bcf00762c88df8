// Shadows, transparency and details on scenes whose areas are known. All are drawn from above or from the front, so that a region's area is
// that of the part of the face, at one page millimetre to a model unit.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "scene/reader.hpp"
#include "view/projected_scene.hpp"
#include "visibility/atherton_weiler/atherton_weiler.hpp"
#include "visibility/atherton_weiler/details.hpp"
#include "visibility/atherton_weiler/shadows.hpp"

namespace ligne {
namespace {

double area(const Region& region) {
  double sum = 0;
  for (const auto& contour : region.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point2 a = contour[i], b = contour[(i + 1) % contour.size()];
      sum += (a.x * b.y - a.y * b.x) / 2;
    }
  }
  return sum;
}

struct Seen {
  Scene scene;
  Topology topology;
  View view;
  std::vector<Region> regions;

  Seen(const char* name, const char* from) {
    Warnings warnings;
    scene = read_scene(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/atherton_weiler/scenes" / name, {}, warnings);
    topology = build_topology(scene);
    CameraRequest request;
    request.named_view = from;
    view = make_view(scene, make_camera(request, scene), {{{0, 0}, {200, 200}}}, {{0, 0}, {200, 200}}, 1);
    regions = *AthertonWeilerMethod().study(project(scene, topology, view, {}), {}).regions;
  }

  /// Areas of a face's regions by the lights that reach them.
  std::map<std::uint32_t, double> lit(std::uint32_t face, const std::vector<Light>& lights) const {
    std::map<std::uint32_t, double> areas;
    for (const Region& r : atherton_weiler::cast_shadows(scene, topology, view, lights, regions)) {
      if (r.face == face) areas[r.lights] += area(r);
    }
    return areas;
  }
};

/// Contours go from page to page through the lattice: a step of 10 nm along some hundred millimetres.
constexpr double kArea = 1e-4;

TEST(Shadows, ASquareOverAFloor) {
  // The shadow is the square, moved by 3: (5, 5) to (8, 8). The square hides (2, 2) to (5, 5) from above.
  const Seen seen("shadow_square.json", "top");
  const auto floor = seen.lit(0, seen.scene.lights), plate = seen.lit(1, seen.scene.lights);
  EXPECT_NEAR(floor.at(0), 9, kArea);
  EXPECT_NEAR(floor.at(1), 100 - 9 - 9, kArea);
  EXPECT_NEAR(plate.at(1), 9, kArea);
  EXPECT_EQ(plate.size(), 1u);
}

TEST(Shadows, AFrameOverAFloorInTwoLights) {
  // Parallel: the frame moved by (8, 8): (10, 10) to (14, 14), its hole (11, 11) to (13, 13). The point at (4, 4, 8) doubles about (4, 4): (0, 0)
  // to (8, 8), hole (2, 2) to (6, 6); of that the frame hides all but ... from above it covers (2, 2) to (6, 6) less (3, 3) to (5, 5).
  const Seen seen("shadow_frame.json", "top");
  const auto floor = seen.lit(0, seen.scene.lights);
  EXPECT_NEAR(floor.at(2), 16 - 4, kArea);   // reached by the point only
  EXPECT_NEAR(floor.at(1), 64 - 16, kArea);  // reached by the parallel light only: the ring (0, 0) to (8, 8) round (2, 2) to (6, 6)
  EXPECT_NEAR(floor.at(3), 400 - 12 - 48 - 12, kArea);
  EXPECT_EQ(floor.count(0), 0u);
}

TEST(Shadows, ALightBehindReachesNothing) {
  const Seen seen("shadow_square.json", "top");
  const auto floor = seen.lit(0, {{Light::Kind::parallel, {0, 0, 1}}}), point = seen.lit(0, {{Light::Kind::point, {5, 5, -4}}});
  EXPECT_NEAR(floor.at(0), 91, kArea);
  EXPECT_EQ(floor.size(), 1u);
  EXPECT_NEAR(point.at(0), 91, kArea);
}

TEST(Shadows, ALightBetweenFacesIsLookedAtAllRound) {
  const Seen seen("shadow_square.json", "top");
  // From (1, 1, 1) the plate, which is above, shades nothing of the floor.
  const auto floor = seen.lit(0, {{Light::Kind::point, {1, 1, 1}}});
  EXPECT_NEAR(floor.at(1), 91, kArea);
}

TEST(Transparency, LevelsAreListedToAnyDepth) {
  // Blue (7 x 7) before red (7 x 7) before the wall; they overlap in 4 x 4.
  const Seen seen("transparent_layers.json", "front");
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
  for (const Region& r : seen.regions) areas[{r.face, r.level}] += area(r);
  const auto at = [&](std::uint32_t face, std::uint32_t level) { return areas[{face, level}]; };
  EXPECT_NEAR(at(2, 0), 49, 1e-6);
  EXPECT_NEAR(at(1, 0), 49 - 16, 1e-6);
  EXPECT_NEAR(at(1, 1), 16, 1e-6);
  EXPECT_NEAR(at(0, 0), 144 - 49 - 49 + 16, 1e-6);
  EXPECT_NEAR(at(0, 1), 49 + 49 - 2 * 16, 1e-6);
  EXPECT_NEAR(at(0, 2), 16, 1e-6);
  EXPECT_EQ(areas.size(), 6u);
}

TEST(Details, AreClippedWithTheirFace) {
  // The first detail is 6 x 8 less a notch of 6 x 4 / 2 = 36; the bar takes one row of 6 from it. The second is a triangle of base 6 and height 4, 12: the
  // hole takes (4, 4) (6, 6) (4, 6) from it, 2; the bar z = 5 to 6 lies before the hole and from x = 5..6 beside it nothing.
  const Seen seen("details.json", "front");
  double painted = 0, all = 0;
  for (const Region& r : atherton_weiler::cut_details(seen.scene, seen.view, seen.regions)) {
    if (r.face != 0) continue;
    all += area(r);
    if (r.material == 1) painted += area(r);
  }
  EXPECT_NEAR(painted, (36 - 6) + (12 - 2), kArea);
  EXPECT_NEAR(all, 192 - 16 - (16 - 4), kArea);
}

}  // namespace
}  // namespace ligne
