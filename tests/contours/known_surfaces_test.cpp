/// Contours on the surfaces that were found behind a mesh: they lie on the outline of the surface itself.

#include "contours/surfaces/known_surfaces.hpp"
#include "contours/contour_chains.hpp"
#include "patches/patch_scenes.hpp"
#include "support/test.hpp"
#include "view/edge_classes.hpp"

namespace ligne::test {
namespace {

/// Triangles of a closed surface of `columns` by `rows` cells.
std::vector<Corners> closed_grid(int columns, int rows, const std::function<Point3(double, double)>& at) {
  std::vector<Corners> polygons;
  add_grid(polygons, columns, rows, true,
           [&](int u, int v) { return at(2 * kPi * (u % columns) / columns, 2 * kPi * (v % rows) / rows); });
  return polygons;
}

/// How far nodes of the contours lie beside the surface of their mesh, and how far its normals there are from square to the
/// sight.
struct Misses {
  std::size_t nodes = 0;
  double distance = 0, facing = 0;
};

Misses measure(const FoundPatches& found, const Camera& camera, bool with_surfaces) {
  const std::vector<LineClass> classes = classify_edges(found.scene, found.topology, camera, 30);
  std::vector<std::uint32_t> outlines;
  for (std::uint32_t e = 0; e < classes.size(); ++e)
    if (classes[e] == LineClass::outline) outlines.push_back(e);
  const std::vector<std::uint8_t> no_creases(classes.size(), 0);
  const RegionBorders borders{30, &no_creases, with_surfaces ? &found.patches : nullptr};
  const SmoothPatch patch = smooth_patch(found.scene, found.topology, camera, outlines, borders);
  Misses misses;
  for (const ContourChain& chain : trace_contours(found.scene, camera, patch))
    for (const ContourNode& node : chain.nodes) {
      if (node.is_cusp()) continue;
      ++misses.nodes;
      misses.distance = std::max(misses.distance, std::abs(found.only().distance(node.on_surface)));
      const Point3 normal = found.only().normal(node.on_surface);
      misses.facing = std::max(misses.facing, std::abs(glm::dot(normal, glm::normalize(to_eye(camera, node.on_surface)))));
    }
  return misses;
}

TEST(KnownSurfaces, NodesOfContoursLieOnTheOutlineOfTheSurface) {
  std::vector<Corners> slanting_tube;
  add_grid(slanting_tube, 24, 4, true, [](int u, int v) {
    const Point3 p = on_circle(5, 2 * kPi * (u % 24) / 24);
    return p + Point3(0, 0, 3 * v + 0.2 * p.x);
  });
  const auto torus = [](double u, double v) { return on_circle(10 + 3 * std::cos(v), u, 3 * std::sin(v)); };
  const std::vector<std::pair<const char*, std::vector<Corners>>> meshes{{"torus", closed_grid(24, 16, torus)},
                                                                         {"tube cut at a slant", slanting_tube}};
  for (const auto& [name, polygons] : meshes) {
    const FoundPatches found(polygons);
    ASSERT_EQ(found.faces().size(), 1u) << name;
    for (const Point3& direction : {Point3(1, 0.3, -0.8), Point3(-0.4, 1, 0.2)}) {
      for (const bool perspective : {false, true}) {
        CameraRequest request;
        (perspective ? request.eye : request.direction) = perspective ? -40.0 * direction : direction;
        const Camera camera = make_camera(request, found.scene);
        const Misses with = measure(found, camera, true), without = measure(found, camera, false);
        ASSERT_GT(with.nodes, 3u) << name;
        EXPECT_LT(with.distance, 1e-5) << name;
        EXPECT_LT(with.facing, 1e-5) << name;
        EXPECT_GT(without.distance + without.facing, 1e-4) << name;  // otherwise nothing would be shown
      }
    }
  }
}

TEST(KnownSurfaces, TurnsAreTheDerivativesOfNormals) {
  for (const SurfaceKind kind : {SurfaceKind::cylinder, SurfaceKind::cone, SurfaceKind::sphere, SurfaceKind::torus}) {
    for (const bool outward : {true, false}) {
      Patch patch;
      patch.outward = outward;
      patch.surface = {kind, {1, 2, 3}, glm::normalize(Point3(1, -2, 2)), 5, kind == SurfaceKind::cone ? 0.4 : 0, 1.5};
      const Point3 p = nearest_point(patch, Point3(4, 6.5, 2));
      EXPECT_NEAR(patch.surface.distance(p), 0, 1e-9);
      const Point3 normal = facing_normal(patch, p);
      for (const Point3& way : frame_of(normal)) {
        constexpr double kStep = 1e-6;
        const Point3 change = (facing_normal(patch, p + kStep * way) - facing_normal(patch, p - kStep * way)) / (2 * kStep);
        EXPECT_LT(glm::length(change - ligne::turned(facing_turn(patch, p), way)), 1e-6)
            << static_cast<int>(kind) << outward;
      }
    }
  }
}

TEST(KnownSurfaces, BandsOfAFreeFormAreNoSurfacesOfTheirOwn) {
  // The rings of a paraboloid are cones.
  std::vector<Corners> polygons;
  add_grid(polygons, 48, 8, false, [](int u, int v) {
    const double radius = 4 + v;
    return on_circle(radius, 2 * kPi * (u % 48) / 48, radius * radius / 20);
  });
  FoundPatches dish(polygons);
  mark_bands(dish.topology, dish.normals, dish.edges, dish.patches);
  ASSERT_GT(dish.faces().size(), 4u);
  for (const auto& [number, faces] : dish.faces()) EXPECT_TRUE(dish.patches.list[number].is_band) << number;
  FoundPatches box(test::rounded_box({6, 5, 4}, 4));
  mark_bands(box.topology, box.normals, box.edges, box.patches);
  ASSERT_GT(box.faces().size(), 12u);
  for (const auto& [number, faces] : box.faces()) EXPECT_FALSE(box.patches.list[number].is_band) << number;
}

}  // namespace
}  // namespace ligne::test
