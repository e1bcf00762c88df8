/// Surfaces found in meshes of known ones.

#include "patches/patch_scenes.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using namespace test;

/// An upright prism between two caps.
std::vector<Corners> prism(int sides) {
  std::vector<Corners> polygons;
  add_grid(polygons, sides, 1, false, [&](int u, int v) { return on_circle(2, 2 * kPi * (u % sides) / sides, 5 * v); });
  Corners bottom, top;
  for (int i = 0; i < sides; ++i) {
    bottom.push_back(on_circle(2, -2 * kPi * i / sides));
    top.push_back(on_circle(2, 2 * kPi * i / sides, 5));
  }
  polygons.push_back(bottom);
  polygons.push_back(top);
  return polygons;
}

class Prisms : public testing::TestWithParam<int> {};

TEST_P(Prisms, AreRoundFromTwelveSidesOn) {
  const int sides = GetParam();
  const FoundPatches found(prism(sides));
  if (sides < 12) {
    EXPECT_TRUE(found.faces().empty());
    EXPECT_EQ(found.count(PatchEdge::inside), 0u);
    return;
  }
  ASSERT_EQ(found.faces().size(), 1u);
  EXPECT_EQ(found.only().kind, SurfaceKind::cylinder);
  EXPECT_NEAR(found.only().radius, 2, 1e-6);
  EXPECT_NEAR(std::abs(found.only().axis.z), 1, 1e-9);
  EXPECT_EQ(found.count(PatchEdge::inside), static_cast<std::size_t>(sides));
  EXPECT_EQ(found.count(PatchEdge::tangent) + found.count(PatchEdge::sharp), 0u);
}

INSTANTIATE_TEST_SUITE_P(Sides, Prisms, testing::Values(3, 4, 5, 6, 8, 10, 11, 12, 13, 16, 24, 32, 48, 64));

TEST(Patches, FindsAConeWithoutItsTip) {
  for (const bool triangles : {false, true}) {
    std::vector<Corners> polygons;
    add_grid(polygons, 20, 2, triangles,
             [](int u, int v) { return on_circle(5 - 1.5 * v, kPi * (u + 0.5 * v) / 20, 2 * v); });
    const FoundPatches found(polygons);
    ASSERT_EQ(found.faces().size(), 1u) << triangles;
    EXPECT_EQ(found.only().kind, SurfaceKind::cone);
    EXPECT_NEAR(std::abs(found.only().slope), 0.75, 1e-5);
    EXPECT_EQ(found.faces().begin()->second, found.scene.faces.size());
  }
}

TEST(Patches, FindsASphere) {
  std::vector<Corners> polygons;
  add_grid(polygons, 24, 8, true, [](int u, int v) {
    const double up = kPi * (v - 4) / 12;
    return Point3(1, 2, 3) + on_circle(4 * std::cos(up), 2 * kPi * (u % 24) / 24, 4 * std::sin(up));
  });
  const FoundPatches found(polygons);
  ASSERT_EQ(found.faces().size(), 1u);
  EXPECT_EQ(found.only().kind, SurfaceKind::sphere);
  EXPECT_NEAR(glm::distance(found.only().at, Point3(1, 2, 3)), 0, 1e-5);
  EXPECT_NEAR(found.only().radius, 4, 1e-5);
}

TEST(Patches, FindsATorus) {
  std::vector<Corners> polygons;
  add_grid(polygons, 30, 12, true, [](int u, int v) {
    const double a = 2 * kPi * (u % 30) / 30, b = 2 * kPi * (v % 12) / 12;
    return on_circle(6 + 2 * std::cos(b), a, 2 * std::sin(b));
  });
  const FoundPatches found(polygons);
  ASSERT_EQ(found.faces().size(), 1u);
  EXPECT_EQ(found.only().kind, SurfaceKind::torus);
  EXPECT_NEAR(found.only().radius, 6, 1e-5);
  EXPECT_NEAR(found.only().tube, 2, 1e-5);
  EXPECT_EQ(found.count(PatchEdge::inside), found.topology.edges.size());
}

TEST(Patches, TheFlatRingsOfATorusBelongToIt) {
  // At the top and at the bottom, the corners on both sides of a ring lie in one plane.
  std::vector<Corners> polygons;
  add_grid(polygons, 48, 20, true, [](int u, int v) {
    const double a = 2 * kPi * (u % 48) / 48, b = 2 * kPi * (v % 20 + 0.5) / 20;
    return on_circle(10 + 2 * std::cos(b), a, 2 * std::sin(b));
  });
  const FoundPatches found(polygons);
  ASSERT_EQ(found.faces().size(), 1u);
  EXPECT_EQ(found.only().kind, SurfaceKind::torus);
  EXPECT_EQ(found.faces().begin()->second, found.scene.faces.size());
}

TEST(Patches, AFlatRingBetweenTwoFilletsIsAPlane) {
  // A plate with a round hole: a ring of width 1, and a quarter of a torus on both sides.
  std::vector<Corners> polygons;
  add_grid(polygons, 48, 13, true, [](int u, int v) {
    const double a = 2 * kPi * (u % 48) / 48, t = kPi / 2 * (v < 7 ? v : v - 1) / 6;
    return on_circle(10 - 2 * std::cos(t) + (v < 7 ? 0 : 1), a, 2 * std::sin(t));
  });
  const FoundPatches found(polygons);
  EXPECT_EQ(found.faces().size(), 2u);
  EXPECT_EQ(found.count(PatchEdge::tangent), 2u * 48);
}

TEST(Patches, NoLinesBetweenTheBandsOfAnEllipsoid) {
  // Each band lies on a cone, and some pairs of them on a sphere, by accident.
  for (const Point3& size : {Point3(60, 40, 30), Point3(60, 40, 40), Point3(30, 30, 50)}) {
    for (const int facets : {24, 48, 96}) {
      SCOPED_TRACE(std::to_string(size.x) + ", " + std::to_string(facets));
      std::vector<Corners> polygons;
      add_grid(polygons, facets, facets / 2 - 2, true, [&](int u, int v) {
        const double down = 2 * kPi * (v + 1) / facets, around = 2 * kPi * (u % facets) / facets;
        return Point3(size.x * std::sin(down) * std::cos(around), size.y * std::sin(down) * std::sin(around),
                      size.z * std::cos(down));
      });
      FoundPatches found(outward(polygons));
      const std::vector<std::uint8_t> no_lines(found.edges.size(), 0);
      drop_loose_tangents(found.scene, found.topology, found.patches, no_lines, found.edges);
      EXPECT_EQ(found.count(PatchEdge::tangent), 0u);
    }
  }
}

/// A strip of planes one behind the other, along y, whose profile turns by these angles (degrees) between lengths.
std::vector<Corners> bent_strip(const std::vector<double>& lengths, const std::vector<double>& turns) {
  std::vector<Corners> polygons;
  Point3 at(0, 0, 0);
  double angle = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Point3 next = at + lengths[i] * Point3(std::cos(angle), 0, std::sin(angle));
    polygons.push_back({at, next, next + Point3(0, 10, 0), at + Point3(0, 10, 0)});
    at = next;
    if (i < turns.size()) angle += turns[i] * kPi / 180;
  }
  return polygons;
}

TEST(Patches, PlanesThatMeetAtSmallAnglesMakeSharpEdges) {
  const FoundPatches found(bent_strip({20, 12, 15, 9, 11}, {12, 15, 22.5, 28}));
  EXPECT_TRUE(found.faces().empty());
  EXPECT_EQ(found.count(PatchEdge::sharp), 4u);
}

TEST(Patches, AFlatSideBetweenEqualChamfersIsNoCylinder) {
  const FoundPatches found(bent_strip({20, 3, 10, 3, 20}, {20, 20, 20, 20}));
  EXPECT_TRUE(found.faces().empty());
  EXPECT_EQ(found.count(PatchEdge::sharp), 4u);
}

TEST(Patches, AFilletOfTwoFacetsIsTangentOnBothSides) {
  // The first and the last bend are half of the one between: the sides are tangent to the circle through the corners.
  const double chord = 2 * std::sin(kPi / 16);
  const FoundPatches found(bent_strip({8, chord, chord, 8}, {11.25, 22.5, 11.25}));
  ASSERT_EQ(found.faces().size(), 1u);
  EXPECT_NEAR(found.only().radius, 1, 1e-5);
  EXPECT_EQ(found.count(PatchEdge::tangent), 2u);
  EXPECT_EQ(found.count(PatchEdge::inside), 1u);
}

TEST(Patches, TheFilletsOfABoxAreCylindersAndSpheres) {
  for (const int steps : {3, 4, 6, 12}) {
    const FoundPatches found(rounded_box({8, 6, 4}, steps));
    std::map<SurfaceKind, std::size_t> kinds;
    for (const auto& [patch, faces] : found.faces()) {
      const PatchSurface& s = found.patches.list[patch].surface;
      ++kinds[s.kind];
      EXPECT_NEAR(s.radius, 1, 1e-4) << steps;
    }
    EXPECT_EQ(kinds[SurfaceKind::cylinder], 12u) << steps;
    EXPECT_EQ(kinds[SurfaceKind::sphere], 8u) << steps;
    EXPECT_EQ(found.count(PatchEdge::sharp), 0u) << steps;
    EXPECT_EQ(found.count(PatchEdge::tangent), 24u + 24u * static_cast<unsigned>(steps)) << steps;
  }
}

TEST(Patches, DoNotDependOnTheOrderOfFaces) {
  std::vector<Corners> polygons = rounded_box({8, 6, 4}, 5);
  const auto radii = [](const FoundPatches& found) {
    std::vector<std::array<double, 4>> all;
    for (const auto& [patch, faces] : found.faces()) {
      const PatchSurface& s = found.patches.list[patch].surface;
      const Point3 middle = s.kind == SurfaceKind::sphere ? s.at : s.at - glm::dot(s.at, s.axis) * s.axis;
      all.push_back({static_cast<double>(faces), std::round(middle.x * 1e3) + 0.0, std::round(middle.y * 1e3) + 0.0,
                     std::round(middle.z * 1e3) + 0.0});
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  const auto expected = radii(FoundPatches(polygons));
  std::mt19937 random(5);
  for (int k = 0; k < 4; ++k) {
    std::shuffle(polygons.begin(), polygons.end(), random);
    EXPECT_EQ(radii(FoundPatches(polygons)), expected);
  }
}

TEST(Patches, ARoughSphereIsFreeform) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> rough(3.97, 4.03);
  std::map<std::pair<int, int>, double> radius;
  for (int u = 0; u < 48; ++u) {
    for (int v = 0; v <= 20; ++v) radius[{u, v}] = rough(random);
  }
  std::vector<Corners> polygons;
  add_grid(polygons, 48, 20, true, [&](int u, int v) {
    const double up = kPi * (v - 10) / 24;
    return radius[{u % 48, v}] *
           Point3(std::cos(up) * std::cos(kPi * u / 24), std::cos(up) * std::sin(kPi * u / 24), std::sin(up));
  });
  const FoundPatches found(polygons);
  EXPECT_TRUE(found.faces().empty());
  EXPECT_EQ(found.count(PatchEdge::sharp), 0u);
  EXPECT_EQ(std::count(found.patches.is_freeform.begin(), found.patches.is_freeform.end(), 0), 0);
}

TEST(Patches, ARowOfFacetsThatBodiesCutIsNoRowOfPlanes) {
  // The facets of a cylinder of thirty, cut slantwise: no corner of the cut lies on the cylinder but those of the rulings.
  std::vector<Corners> polygons;
  for (int i = 0; i < 8; ++i) {
    const Point3 a = on_circle(10, 2 * kPi * i / 30), b = on_circle(10, 2 * kPi * (i + 1) / 30);
    const Point3 up(0, 0, 6), third = (2.0 * a + b) / 3.0;
    polygons.push_back({a, third - Point3(0, 0, 0.7), b, b + up, third + up + Point3(0, 0, 0.9), a + up});
  }
  const FoundPatches found(polygons);
  EXPECT_EQ(found.count(PatchEdge::sharp), 0u);
}

TEST(Patches, AStripOfTrianglesBetweenApproximatedEndsIsACylinder) {
  // A quarter of a cylinder whose corners lie on two curves alone, at other angles on each, up to a sixth of the sag beside
  // it. Both sides go on as planes.
  const int facets = 24;
  const double turn = kPi / 2 / facets, off = turn * turn / 48;
  const auto at = [&](double k, double y) {
    const double radius = 1 + off * std::sin(7 * k + y);
    return Point3(radius * std::sin(turn * k), y, radius * std::cos(turn * k));
  };
  std::vector<Corners> polygons;
  const auto low = [&](int k) { return at(k, 0); };
  const auto high = [&](int k) { return at(k == 0 || k == facets ? k : k + 0.4, 30); };
  for (int k = 0; k < facets; ++k) {
    polygons.push_back({low(k), low(k + 1), high(k)});
    polygons.push_back({low(k + 1), high(k + 1), high(k)});
  }
  const Point3 left(-20, 0, 0), down(0, 0, -20);
  polygons.push_back({low(0) + left, low(0), high(0), high(0) + left});
  polygons.push_back({low(facets), low(facets) + down, high(facets) + down, high(facets)});
  const FoundPatches found(polygons);
  ASSERT_EQ(found.faces().size(), 1u);
  EXPECT_EQ(found.only().kind, SurfaceKind::cylinder);
  EXPECT_NEAR(found.only().radius, 1, 20 * off);  // a quarter of a turn tells less of the radius than of the surface
  EXPECT_EQ(found.faces().begin()->second, 2u * facets);
  EXPECT_EQ(found.count(PatchEdge::tangent), 2u);
}

TEST(Patches, AFilletOfThreeBandsBesideABossIsATorus) {
  const int sides = 24, steps = 3;
  std::vector<Corners> polygons;
  add_grid(polygons, sides, steps, true, [](int u, int v) {
    const double b = kPi / 2 * v / steps;
    return on_circle(6 - 2 * std::sin(b), 2 * kPi * (u % sides) / sides, 2 - 2 * std::cos(b));
  });
  add_grid(polygons, sides, 1, true, [](int u, int v) { return on_circle(4, 2 * kPi * (u % sides) / sides, 2 + 3.0 * v); });
  for (int u = 0; u < sides; ++u) {
    const double a = 2 * kPi * u / sides, b = 2 * kPi * ((u + 1) % sides) / sides;
    polygons.push_back({on_circle(20, a), on_circle(20, b), on_circle(6, b), on_circle(6, a)});
  }
  const FoundPatches found(polygons);
  ASSERT_EQ(found.faces().size(), 2u);
  std::map<SurfaceKind, const PatchSurface*> kinds;
  for (const auto& [patch, faces] : found.faces()) {
    kinds[found.patches.list[patch].surface.kind] = &found.patches.list[patch].surface;
  }
  ASSERT_TRUE(kinds.contains(SurfaceKind::torus) && kinds.contains(SurfaceKind::cylinder));
  EXPECT_NEAR(kinds[SurfaceKind::torus]->tube, 2, 1e-4);
  EXPECT_NEAR(kinds[SurfaceKind::torus]->radius, 6, 1e-4);
  EXPECT_EQ(found.count(PatchEdge::tangent), 2u * sides);
}

TEST(Patches, AreFoundWhereCsgCutTheirFacets) {
  for (const int facets : {24, 30, 48}) {
    const FoundPatches found(csg_plug(25, 12.5, facets));
    std::map<SurfaceKind, std::size_t> kinds;
    for (const auto& [patch, faces] : found.faces()) {
      const PatchSurface& surface = found.patches.list[patch].surface;
      ++kinds[surface.kind];
      EXPECT_NEAR(surface.radius, surface.kind == SurfaceKind::sphere ? 25 : 12.5, 1e-3) << facets;
    }
    EXPECT_EQ(kinds[SurfaceKind::cylinder], 1u) << facets << " facets to a turn";
    EXPECT_EQ(kinds[SurfaceKind::sphere], 2u) << facets << " facets to a turn";
    EXPECT_EQ(kinds.size(), 2u);
    EXPECT_EQ(std::count(found.patches.patch_of.begin(), found.patches.patch_of.end(), kNone), 0) << facets;
  }
}

}  // namespace
}  // namespace ligne
