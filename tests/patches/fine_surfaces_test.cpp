/// Surfaces of few facets, and of facets that are hardly larger than the rounding of their coordinates.

#include "patches/rounded_scenes.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using namespace test;

/// A tube and what it has: two cylinders, and four rims.
void expect_tube(const Scene& scene, int sides, double radius) {
  const FoundPatches found(scene);
  const auto faces = found.faces();
  ASSERT_EQ(faces.size(), 2u);
  for (const auto& [patch, count] : faces) {
    const PatchSurface& surface = found.patches.list[patch].surface;
    EXPECT_EQ(surface.kind, SurfaceKind::cylinder);
    EXPECT_EQ(count, 2u * static_cast<std::size_t>(sides));
    EXPECT_LE(std::min(std::abs(surface.radius - radius), std::abs(surface.radius - radius / 2)),
              4 * scene.objects[0].precision);
  }
  EXPECT_EQ(found.count(PatchEdge::tangent), 0u);
  EXPECT_EQ(count_creases(scene), 4u * static_cast<std::size_t>(sides));
}

class FineSurfaces : public testing::TestWithParam<int> {};

TEST_P(FineSurfaces, RoundedTubesAreTwoCylinders) {
  for (const double radius : {1.0, 5.0}) {
    for (const double step : {1e-3, 1e-4, 1e-5, 1e-6}) {
      // A facet of the bore is as wide as five steps there: its normal tells nothing.
      if (GetParam() > 100 && step * 1000 > radius / 2) continue;
      SCOPED_TRACE(testing::Message() << radius << " " << step);
      expect_tube(rounded_scene(tube(GetParam(), radius), step), GetParam(), radius);
    }
  }
}

TEST_P(FineSurfaces, TubesOfFloat32FarFromTheOriginAreTwoCylinders) {
  for (const double radius : {1.0, 5.0}) {
    for (const double far : {100.0, 1000.0, 3000.0}) {
      SCOPED_TRACE(testing::Message() << radius << " " << far);
      std::vector<Corners> polygons = tube(GetParam(), radius);
      for (Corners& polygon : polygons) {
        for (Point3& p : polygon) p += far * Point3(1, 1.3, -0.7);
      }
      expect_tube(scene_of(polygons), GetParam(), radius);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, FineSurfaces, testing::Values(100, 600));

TEST(ShortFillets, AreCylindersWhateverTheOrderOfFaces) {
  const std::vector<Corners> box = rounded_box({4, 3, 2.5}, 3);
  for (std::size_t first = 0; first < box.size(); first += 7) {
    for (const bool turned : {false, true}) {
      std::vector<Corners> polygons(box.begin() + static_cast<std::ptrdiff_t>(first), box.end());
      polygons.insert(polygons.end(), box.begin(), box.begin() + static_cast<std::ptrdiff_t>(first));
      if (turned) std::reverse(polygons.begin(), polygons.end());
      const FoundPatches found(polygons);
      std::size_t cylinders = 0;
      for (const auto& [patch, count] : found.faces())
        cylinders += found.patches.list[patch].surface.kind == SurfaceKind::cylinder;
      EXPECT_EQ(cylinders, 12u) << first << turned;
    }
  }
}

TEST(FineSurfaces, ARoundedRowOfTrianglesIsNoSphere) {
  // Both circles of a row on a cone lie on a sphere, too.
  for (const int sides : {120, 170, 240}) {
    std::vector<Corners> polygons;
    add_grid(polygons, sides, 1, true,
             [&](int u, int v) { return on_circle(6 - 1.5 * v, 2 * kPi * (u % sides) / sides, 2 * v); });
    const FoundPatches found(rounded_scene(polygons, 0.002));
    for (const auto& [patch, count] : found.faces())
      EXPECT_NE(found.patches.list[patch].surface.kind, SurfaceKind::sphere) << sides;
    EXPECT_EQ(found.count(PatchEdge::tangent) + found.count(PatchEdge::sharp), 0u) << sides;
  }
}

TEST(FineSurfaces, TheSidesOfAThreadAreNoSurfaces) {
  // Pieces of a helicoid lie on cylinders and tori within some roundings, and leave them slowly.
  std::vector<Corners> polygons;
  add_grid(polygons, 600, 3, true, [](int u, int v) {
    return on_circle(8 + v / 3.0, 2 * kPi * u / 200, 2.0 * u / 200 + 0.5 * v / 3) + Point3(220, 264, 0);
  });
  const FoundPatches found(polygons);
  EXPECT_TRUE(found.faces().empty());
  EXPECT_EQ(found.count(PatchEdge::tangent), 0u);
}

}  // namespace
}  // namespace ligne
