/// Finer meshes of recognised surfaces: new vertices lie on the surfaces, and bodies stay closed.

#include "scene/patches/refine/refine_scene.hpp"
#include "base/no_index.hpp"
#include "patches/part_scenes.hpp"
#include "support/mesh_script.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

RefineLimits limit_of(double most) {
  return {most, [](const Point3&) { return 1.0; }};
}

std::vector<Corners> turned_polygons(const std::vector<Point2>& profile, int facets) {
  return turned_body(facets, profile, true);
}

Scene turned(const std::vector<Point2>& profile, int facets) { return scene_of(turned_polygons(profile, facets)); }

/// Two bodies, the second one moved.
Scene both(std::vector<Corners> first, const std::vector<Corners>& second, const Point3& by) {
  for (Corners polygon : second) {
    for (Point3& p : polygon) p += by;
    first.push_back(polygon);
  }
  return scene_of(first);
}

struct Refined {
  Scene given;
  Topology topology;
  Creases creases;
  std::optional<RefinedScene> scene;

  Refined(Scene from, double most) : given(std::move(from)), topology(build_topology(given)) {
    creases = find_creases(given, topology, {});
    scene = refine_scene(given, topology, limit_of(most), creases);
  }
};

/// A column with a hollow fillet at its foot, on a disk.
std::vector<Point2> column_on_disk() {
  std::vector<Point2> profile{{20, 0}, {20, 4}};
  for (int k = 0; k <= 4; ++k) {
    const double turn = kPi / 2 * k / 4;
    profile.emplace_back(11 - 3 * std::sin(turn), 7 - 3 * std::cos(turn));
  }
  profile.emplace_back(8, 20);
  return profile;
}

TEST(RefineScene, PutsNewVerticesOnTheSurfacesAndKeepsBodiesClosed) {
  constexpr double kMost = 0.05;
  for (const int facets : {12, 16, 24}) {
    const Refined refined(turned(column_on_disk(), facets), kMost);
    ASSERT_TRUE(refined.scene) << facets;
    const Scene& scene = refined.scene->scene;
    const Topology& topology = refined.scene->topology;
    ASSERT_EQ(refined.scene->face_of.size(), scene.faces.size());
    ASSERT_EQ(refined.creases.lines.size(), topology.edges.size());
    ASSERT_EQ(refined.creases.patches.patch_of.size(), scene.faces.size());
    EXPECT_GT(scene.faces.size(), 2 * refined.given.faces.size());
    std::size_t creases = 0, given_creases = 0;
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      const Edge& edge = topology.edges[e];
      ASSERT_NE(edge.face1, kNone) << "an open edge, " << facets;
      EXPECT_EQ(topology.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound), 0);
      const Point3 middle = 0.5 * (scene.vertices[edge.v0] + scene.vertices[edge.v1]);
      for (const std::uint32_t face : {edge.face0, edge.face1}) {
        const std::uint32_t patch = refined.creases.patches.patch_of[face];
        if (patch == kNone) continue;
        const PatchSurface& surface = refined.creases.patches.list[patch].surface;
        EXPECT_LT(std::abs(surface.distance(scene.vertices[edge.v0])), 1e-3);
        EXPECT_LT(std::abs(surface.distance(middle)), kMost);
      }
      creases += refined.creases.lines[e] == kCreaseLine;
      if (refined.scene->edge_of[e] != kNone) {
        EXPECT_LT(refined.scene->edge_of[e], refined.topology.edges.size());
      }
    }
    const Creases before = find_creases(refined.given, refined.topology, {});
    for (const std::uint8_t line : before.lines) given_creases += line == kCreaseLine;
    EXPECT_EQ(creases % static_cast<std::size_t>(2 * facets), 0u) << "rings of creases are halved as wholes";
    EXPECT_GT(creases, given_creases);
  }
}

TEST(RefineScene, HalvesTheCircleAlongWhichAPlaneTouchesATorus) {
  // A bolt with a round head: its flat top touches the torus.
  std::vector<Point2> profile{{20, 0}};
  for (int k = 0; k <= 4; ++k) {
    const double turn = kPi / 2 * k / 4;
    profile.emplace_back(12 + 8 * std::cos(turn), 10 + 8 * std::sin(turn));
  }
  constexpr int kSides = 16;
  const Refined refined(turned(profile, kSides), 0.01);
  ASSERT_TRUE(refined.scene);
  const Scene& scene = refined.scene->scene;
  std::size_t on_top = 0;
  for (const Edge& edge : refined.scene->topology.edges) {
    const Point3 &a = scene.vertices[edge.v0], &b = scene.vertices[edge.v1];
    const bool is_rim = std::abs(a.z - 18) < 1e-4 && std::abs(b.z - 18) < 1e-4;
    if (!is_rim) continue;
    ++on_top;
    EXPECT_NEAR(glm::length(Point2(a)), 12, 1e-4);
    EXPECT_LE(glm::distance(a, b), 2 * 12 * std::sin(kPi / kSides) / 2);
  }
  EXPECT_GE(on_top, std::size_t{4 * kSides});
}

TEST(RefineScene, LeavesFineMeshesAndPolygonsAlone) {
  EXPECT_FALSE(Refined(turned(column_on_disk(), 24), 10).scene);
  EXPECT_FALSE(Refined(turned({{5, 0}, {5, 8}}, 6), 0.01).scene) << "a hexagonal prism";
}

TEST(RefineScene, LeavesSurfacesWithAnOpenBorderAlone) {
  std::vector<Corners> polygons;
  add_grid(polygons, 16, 1, true, [&](int u, int v) { return on_circle(5, 2 * kPi * (u % 16) / 16, 8.0 * v); });
  EXPECT_FALSE(Refined(scene_of(polygons), 0.01).scene);
}

TEST(RefineScene, MovesCornersOnChordsOntoBothSurfaces) {
  constexpr double kMost = 0.02;
  for (const int facets : {24, 30, 48}) {
    const Refined refined(scene_of(csg_plug(25, 12.5, facets)), kMost);
    ASSERT_TRUE(refined.scene) << facets;
    const Scene& scene = refined.scene->scene;
    const Topology& topology = refined.scene->topology;
    std::size_t creases = 0;
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      const Edge& edge = topology.edges[e];
      ASSERT_NE(edge.face1, kNone) << "an open edge, " << facets;
      creases += refined.creases.lines[e] == kCreaseLine;
      for (const std::uint32_t face : {edge.face0, edge.face1}) {
        const std::uint32_t patch = refined.creases.patches.patch_of[face];
        ASSERT_NE(patch, kNone);
        const PatchSurface& surface = refined.creases.patches.list[patch].surface;
        EXPECT_LT(std::abs(surface.distance(scene.vertices[edge.v0])), 2e-3) << facets;
        EXPECT_LT(std::abs(surface.distance(scene.vertices[edge.v1])), 2e-3) << facets;
      }
      if (refined.creases.lines[e] != kCreaseLine) continue;
      // Both rims are circles about x.
      for (const std::uint32_t v : {edge.v0, edge.v1}) {
        EXPECT_NEAR(std::hypot(scene.vertices[v].y, scene.vertices[v].z), 12.5, 2e-3);
        EXPECT_NEAR(std::abs(scene.vertices[v].x), std::sqrt(25 * 25 - 12.5 * 12.5), 2e-3);
      }
    }
    EXPECT_GT(creases, static_cast<std::size_t>(4 * facets));
  }
}

TEST(RefineScene, LeavesBodiesThatTouchAlone) {
  const std::vector<Corners> pin = turned_polygons({{5, 0}, {5, 20}}, 16);
  // A sleeve, whose bore is the pin's wall turned over.
  const auto sleeve = [&](double bore, int facets) {
    std::vector<Corners> faces;
    const std::vector<Point2> profile{{bore, 5}, {9, 5}, {9, 15}, {bore, 15}, {bore, 5}};
    add_grid(faces, facets, 4, true, [&](int u, int v) {
      const Point2 p = profile[static_cast<std::size_t>(v)];
      return on_circle(p.x, 2 * kPi * (u % facets) / facets, p.y);
    });
    return faces;
  };
  EXPECT_FALSE(Refined(both(pin, sleeve(5, 16), Point3(0.0)), 0.01).scene) << "a pin in its bore";
  EXPECT_TRUE(Refined(both(pin, sleeve(7, 16), Point3(0.0)), 0.01).scene) << "a pin in a wider bore";
  EXPECT_TRUE(Refined(both(sleeve(5, 16), sleeve(5, 24), Point3(0, 0, 10)), 0.01).scene) << "bores that continue each other";
  EXPECT_TRUE(Refined(both(pin, pin, Point3(6, 0, 5)), 0.01).scene) << "two pins in each other";
  EXPECT_TRUE(Refined(both(pin, pin, Point3(12, 0, 0)), 0.01).scene) << "two pins beside each other";
  EXPECT_FALSE(Refined(both(pin, pin, Point3(10, 0, 0)), 0.01).scene) << "two pins that touch";
}

[[maybe_unused]] const bool scripts_are_added = add_mesh_scripts(LIGNE_SOURCE_DIR "/tests/patches/scripts");

}  // namespace
}  // namespace ligne::test
