/// The list of surfaces behind a mesh: which part of each the faces cover.

#include "scene/patches/found_surfaces.hpp"
#include "support/test.hpp"

#include "patches/part_scenes.hpp"

namespace ligne {
namespace {

using namespace test;

FoundSurfaces surfaces_of(const std::vector<Corners>& polygons) {
  const FoundPatches found(polygons);
  FoundSurfaces surfaces = found_surfaces(found.scene, found.patches);
  std::vector<std::size_t> faces(surfaces.list.size(), 0);
  for (const std::uint32_t number : surfaces.of_face) {
    if (number != kNone) ++faces.at(number);
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    EXPECT_EQ(surfaces.list[i].faces, faces[i]) << i;
    EXPECT_GT(faces[i], 0u) << i;
  }
  return surfaces;
}

/// The surfaces of one kind, by their radii.
std::vector<FoundSurface> of_kind(const FoundSurfaces& found, SurfaceKind kind) {
  std::vector<FoundSurface> some;
  std::ranges::copy_if(found.list, std::back_inserter(some), [&](const FoundSurface& f) { return f.surface.kind == kind; });
  std::ranges::sort(some, {}, [](const FoundSurface& f) { return f.surface.radius; });
  return some;
}

void expect_near(const Point3& found, const Point3& known, double tolerance = 1e-5) {
  EXPECT_LT(glm::distance(found, known), tolerance) << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(FoundSurfaces, TheBoresOfAPlate) {
  const FoundSurfaces found = surfaces_of(bored_plate(2.5, 4));
  ASSERT_EQ(found.list.size(), 2u);
  const auto bores = of_kind(found, SurfaceKind::cylinder);
  ASSERT_EQ(bores.size(), 2u);
  for (const std::size_t i : {0, 1}) {
    const FoundSurface& bore = bores[i];
    EXPECT_NEAR(bore.surface.radius, i == 0 ? 2.5 : 4, 1e-5);
    EXPECT_LT(std::abs(bore.surface.radius - (i == 0 ? 2.5 : 4)), bore.error);
    EXPECT_LT(bore.error, 1e-4);
    EXPECT_FALSE(bore.outward);
    expect_near(bore.surface.axis, {0, 0, 1}, 1e-7);
    expect_near(bore.surface.at, {i == 0 ? 10 : 30, 10, 0});
    EXPECT_EQ(bore.along[0], 0);
    EXPECT_NEAR(bore.along[1], 5, 1e-5);
    EXPECT_EQ(bore.turn, 360);
    EXPECT_EQ(bore.faces, static_cast<std::size_t>(kBoreFacets));
    EXPECT_NEAR(bore.sag, bore.surface.radius * (1 - std::cos(kPi / kBoreFacets)), 1e-4);
    EXPECT_EQ(bore.object, 0u);
  }
}

TEST(FoundSurfaces, ATurnedPartHasACylinderAFilletAndACone) {
  const FoundSurfaces found = surfaces_of(turned_part());
  ASSERT_EQ(found.list.size(), 3u);
  const auto shafts = of_kind(found, SurfaceKind::cylinder), cones = of_kind(found, SurfaceKind::cone),
             fillets = of_kind(found, SurfaceKind::torus);
  ASSERT_EQ(shafts.size(), 1u);
  EXPECT_NEAR(shafts[0].surface.radius, 6, 1e-5);
  EXPECT_TRUE(shafts[0].outward);
  EXPECT_NEAR(shafts[0].along[1], 5, 1e-5);
  ASSERT_EQ(cones.size(), 1u);
  expect_near(cones[0].surface.at, {0, 0, 7});
  expect_near(cones[0].surface.axis, {0, 0, 1}, 1e-7);
  EXPECT_NEAR(cones[0].surface.radius, 12, 1e-5) << "where the faces begin";
  EXPECT_NEAR(cones[0].surface.slope, -0.5, 1e-5);
  EXPECT_NEAR(cones[0].along[1], 6, 1e-5);
  EXPECT_EQ(cones[0].turn, 360);
  EXPECT_TRUE(cones[0].outward);
  ASSERT_EQ(fillets.size(), 1u);
  expect_near(fillets[0].surface.at, {0, 0, 5}, 1e-4);
  EXPECT_NEAR(fillets[0].surface.radius, 8, 1e-4);
  EXPECT_NEAR(fillets[0].surface.tube, 2, 1e-4);
  EXPECT_FALSE(fillets[0].outward);
}

TEST(FoundSurfaces, ABallLooksOutwardAndADimpleDoesNot) {
  std::vector<Corners> polygons = ball();
  for (const bool outward : {true, false}) {
    const FoundSurfaces found = surfaces_of(polygons);
    ASSERT_EQ(found.list.size(), 1u);
    EXPECT_EQ(found.list[0].surface.kind, SurfaceKind::sphere);
    expect_near(found.list[0].surface.at, {1, 2, 3});
    EXPECT_NEAR(found.list[0].surface.radius, 4, 1e-5);
    EXPECT_EQ(found.list[0].outward, outward);
    EXPECT_EQ(found.list[0].faces, polygons.size());
    for (Corners& polygon : polygons) std::reverse(polygon.begin(), polygon.end());
  }
}

/// Strips of a cylinder of radius 5 between two angles, in degrees, from z = 0 to 8.
std::vector<Corners> shell(double from, double to) {
  std::vector<Corners> polygons;
  const int facets = static_cast<int>(std::ceil((to - from) / 7.5));
  add_grid(polygons, facets, 1, false,
           [&](int u, int v) { return on_circle(5, (from + (to - from) * u / facets) * kPi / 180, 8.0 * v); });
  return polygons;
}

TEST(FoundSurfaces, TheTurnIsThatOfTheFaces) {
  const std::array<std::array<double, 2>, 6> turns{{{0, 90}, {135, 225}, {-100, 100}, {90, 390}, {-179, 170}, {160, 200}}};
  for (const auto& [from, to] : turns) {
    const FoundSurfaces found = surfaces_of(shell(from, to));
    ASSERT_EQ(found.list.size(), 1u) << from;
    EXPECT_NEAR(found.list[0].turn, to - from, 1e-3) << from;
    EXPECT_NEAR(found.list[0].surface.radius, 5, found.list[0].error) << from;
  }
}

TEST(FoundSurfaces, AShellWithASlitCoversTheRest) {
  std::vector<Corners> polygons = shell(10, 350);
  const FoundSurfaces one = surfaces_of(polygons);
  ASSERT_EQ(one.list.size(), 1u);
  EXPECT_NEAR(one.list[0].turn, 340, 1e-3);
  // Two windows in one surface: their angles are missing, whatever order the faces have.
  std::vector<Corners> upper;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (i % 12 != 5) upper.push_back(polygons[i]);
  }
  std::reverse(upper.begin(), upper.end());
  double sum = 0;
  for (const FoundSurface& part : surfaces_of(upper).list) sum += part.turn;
  EXPECT_NEAR(sum, 340.0 * static_cast<double>(upper.size()) / static_cast<double>(polygons.size()), 1e-2);
}

TEST(FoundSurfaces, AnAxisHasADirectionOfItsOwn) {
  for (const Point3& turn : {Point3(1, 1, 1), Point3(-1, 1, -1), Point3(1, -1, -1)}) {
    std::vector<Corners> polygons = shell(0, 200);
    for (Corners& polygon : polygons) {
      for (Point3& p : polygon) p = {turn.z * p.z, turn.y * p.y, turn.x * p.x};
    }
    const FoundSurfaces found = surfaces_of(polygons);
    ASSERT_EQ(found.list.size(), 1u);
    expect_near(found.list[0].surface.axis, {1, 0, 0}, 1e-7);
    EXPECT_NEAR(found.list[0].surface.at.x, std::min(0.0, 8 * turn.z), 1e-6);
  }
}

TEST(FoundSurfaces, FewerAnglesTellLess) {
  const double whole = surfaces_of(shell(0, 180)).list.at(0).error, part = surfaces_of(shell(0, 30)).list.at(0).error;
  EXPECT_GT(part, 10 * whole);
}

TEST(FoundSurfaces, ThereAreNoneInABox) {
  const FoundSurfaces found = surfaces_of(outward({{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}}));
  EXPECT_TRUE(found.list.empty());
  EXPECT_TRUE(found.of_face.empty());
}

TEST(FoundSurfaces, NumbersAreThoseOfTheListWhateverBecameOfPatches) {
  for (const int steps : {3, 6}) {
    const FoundSurfaces found = surfaces_of(rounded_box({8, 6, 4}, steps));
    EXPECT_EQ(found.list.size(), 20u);
    for (const FoundSurface& cylinder : of_kind(found, SurfaceKind::cylinder)) {
      EXPECT_NEAR(cylinder.turn, 90, 1e-2);
      EXPECT_TRUE(cylinder.outward);
    }
  }
}

}  // namespace
}  // namespace ligne
