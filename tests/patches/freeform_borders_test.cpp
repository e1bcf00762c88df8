/// Free forms between planes.

#include "scene/patches/borders/freeform_borders.hpp"
#include "support/test.hpp"

#include "patches/patch_scenes.hpp"

namespace ligne {
namespace {

using namespace test;

/// A quarter of an ellipse of two semi-axes, drawn along y in rows of triangles, with a plane of length 20 on both sides.
/// The first one goes on from the ellipse at an angle, degrees; the other one is tangent.
std::vector<Corners> rounded_edge(int facets, double wide, double high, double angle) {
  std::vector<Corners> polygons;
  const auto at = [&](int u, int v) {
    const double t = kPi / 2 * u / facets;
    return Point3(wide * std::sin(t), 3 * v, -high * (1 - std::cos(t)));
  };
  add_grid(polygons, facets, 4, true, at);
  const double radians = angle * kPi / 180;
  const Point3 back = 20.0 * Point3(-std::cos(radians), 0, -std::sin(radians)), down(0, 0, -20);
  Corners first{at(0, 0) + back}, second{at(facets, 0) + down, at(facets, 4) + down};
  for (int v = 0; v <= 4; ++v) {
    first.push_back(at(0, v));
    second.push_back(at(facets, 4 - v));
  }
  first.push_back(at(0, 4) + back);
  polygons.push_back(first);
  polygons.push_back(second);
  return polygons;
}

/// Edges of a kind along y at a place of the profile.
std::size_t count_at(const FoundPatches& found, PatchEdge kind, double x) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < found.edges.size(); ++e) {
    const Point3 &a = found.scene.vertices[found.topology.edges[e].v0],
                 &b = found.scene.vertices[found.topology.edges[e].v1];
    count += found.edges[e] == kind && std::abs(a.x - x) < 1e-4 && std::abs(b.x - x) < 1e-4;
  }
  return count;
}

class EllipticFillets : public testing::TestWithParam<int> {};

TEST_P(EllipticFillets, RunIntoThePlanesOnBothSides) {
  const FoundPatches found(rounded_edge(GetParam(), 4, 2, 0));
  EXPECT_EQ(count_at(found, PatchEdge::tangent, 0), 4u);
  EXPECT_EQ(count_at(found, PatchEdge::tangent, 4), 4u);
  EXPECT_EQ(found.count(PatchEdge::tangent), 8u);
  EXPECT_EQ(found.count(PatchEdge::sharp), 0u);
}

TEST_P(EllipticFillets, MeetAPlaneAtAnAngle) {
  // The plane rises from the ellipse by 20 degrees, less than facets of one surface may bend.
  const FoundPatches found(rounded_edge(GetParam(), 4, 2, 20));
  EXPECT_EQ(count_at(found, PatchEdge::sharp, 0), 4u);
  EXPECT_EQ(count_at(found, PatchEdge::tangent, 4), 4u);
  EXPECT_EQ(found.count(PatchEdge::sharp), 4u);
  EXPECT_EQ(found.count(PatchEdge::tangent), 4u);
}

INSTANTIATE_TEST_SUITE_P(Facets, EllipticFillets, testing::Values(8, 12, 24));

/// The ends of finer ones lie on cylinders of their own.
TEST(CoarseEllipticFillets, RunIntoACylinder) {
  // The ellipse ends with a radius of 1, and the cylinder of radius 20 goes on from there.
  std::vector<Corners> polygons = rounded_edge(12, 4, 2, 0);
  polygons.pop_back();
  const auto at = [](int u, int v) {
    const double t = 5 * kPi / 180 * u;
    return Point3(-16 + 20 * std::cos(t), 3 * v, -2 - 20 * std::sin(t));
  };
  add_grid(polygons, 8, 4, true, at);
  const Point3 inwards(-20, 0, 0);
  polygons.push_back({at(8, 0), at(8, 0) + inwards, at(8, 4) + inwards, at(8, 4), at(8, 3), at(8, 2), at(8, 1)});
  const FoundPatches found(polygons);
  EXPECT_EQ(count_at(found, PatchEdge::tangent, 0), 4u);
  EXPECT_EQ(count_at(found, PatchEdge::tangent, 4), 4u);
  EXPECT_EQ(found.count(PatchEdge::tangent), 8u);
}

/// A free form of one facet's depth, along y, that turns by about 17 degrees between a cylinder and a plane.
TEST(ShallowFreeforms, RunIntoACylinderAndAPlane) {
  const double radius = 14, plane_angle = 12, plane_distance = 13.607;
  const auto normal = [](double degrees) { return Point3(std::sin(degrees * kPi / 180), 0, std::cos(degrees * kPi / 180)); };
  // The border of the cylinder wavers round 5 degrees, and that of the plane lies as far beyond the line where both meet.
  const std::array<double, 7> border{-5, -4.6, -5.3, -4.7, -5.4, -4.9, -5.2};
  const int rows = 6, columns = 8;
  const auto along = [](int v) { return Point3(0, 3.0 * v, 0); };
  const auto on_cylinder = [&](int u, int v) {
    return radius * normal(u < columns ? -45 + 5.0 * u : border[static_cast<std::size_t>(v)]) + along(v);
  };
  const auto on_form = [&](int u, int v) {
    const double from = border[static_cast<std::size_t>(v)], turn = (plane_angle - from) * kPi / 180;
    const double way = (plane_distance - radius * std::cos(turn)) / std::sin(turn);
    const Point3 begin = radius * normal(from);
    return begin + (u == 0 ? 0.0 : way) * (normal(from + 90) + normal(plane_angle + 90)) + along(v);
  };
  std::vector<Corners> polygons;
  add_grid(polygons, columns, rows, true, on_cylinder);
  add_grid(polygons, 1, rows, true, on_form);
  const Point3 beyond = 20.0 * normal(plane_angle + 90), before = -20.0 * normal(45);
  Corners last{on_form(1, 0) + beyond, on_form(1, rows) + beyond};
  Corners first{on_cylinder(0, rows) + before, on_cylinder(0, 0) + before};
  for (int v = 0; v <= rows; ++v) {
    last.push_back(on_form(1, rows - v));
    first.push_back(on_cylinder(0, v));
  }
  polygons.push_back(last);
  polygons.push_back(first);
  const FoundPatches found(polygons);
  std::size_t count = 0;
  for (std::size_t e = 0; e < found.edges.size(); ++e) {
    const auto is_at_border = [&](std::uint32_t v) {
      const Point3& p = found.scene.vertices[v];
      return std::abs(std::hypot(p.x, p.z) - radius) < 1e-4 && p.x > radius * normal(-8).x;
    };
    const Edge& edge = found.topology.edges[e];
    count += is_at_border(edge.v0) && is_at_border(edge.v1) && found.edges[e] == PatchEdge::tangent;
  }
  EXPECT_EQ(count, static_cast<std::size_t>(rows));
  EXPECT_EQ(found.count(PatchEdge::sharp), 0u);
}

}  // namespace
}  // namespace ligne
