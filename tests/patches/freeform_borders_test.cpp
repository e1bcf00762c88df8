/// Free forms between planes.

#include "scene/patches/borders/freeform_borders.hpp"
#include "support/test.hpp"

#include "patches/patch_scenes.hpp"

namespace ligne {
namespace {

using namespace test;

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
