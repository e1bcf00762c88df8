/// Finer meshes of recognised surfaces: new vertices lie on the surfaces, and bodies stay closed.

#include "scene/patches/refine/refine_scene.hpp"
#include "base/no_index.hpp"
#include "support/mesh_script.hpp"
#include "support/mesh_text.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

RefineLimits limit_of(double most) {
  return {most, [](const Point3&) { return 1.0; }};
}

struct Refined {
  Scene given;
  Topology topology;
  Creases creases;
  std::optional<RefinedScene> scene;

  Refined(const std::string& mesh, double most) : given(mesh_of(mesh).scene()), topology(build_topology(given)) {
    creases = find_creases(given, topology, {});
    scene = refine_scene(given, topology, limit_of(most), creases);
  }
};

std::string turned(int facets, const std::string& circles) {
  return "shape turned-body " + std::to_string(facets) + " " + circles + " triangles";
}

/// A column with a hollow fillet at its foot, on a disk.
const std::string kColumnOnDisk =
    "20,0 20,4 11,4 11-3*sin(pi/8),7-3*cos(pi/8) 11-3*sin(pi/4),7-3*cos(pi/4) 11-3*cos(pi/8),7-3*sin(pi/8) 8,7 8,20";

TEST(RefineScene, PutsNewVerticesOnTheSurfacesAndKeepsBodiesClosed) {
  constexpr double kMost = 0.05;
  for (const int facets : {12, 16, 24}) {
    const Refined refined(turned(facets, kColumnOnDisk), kMost);
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
  constexpr int kSides = 16;
  const Refined refined(turned(kSides,
                               "20,0 20,10 12+8*cos(pi/8),10+8*sin(pi/8) 12+8*cos(pi/4),10+8*sin(pi/4) "
                               "12+8*sin(pi/8),10+8*cos(pi/8) 12,18"),
                        0.01);
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
  EXPECT_FALSE(Refined(turned(24, kColumnOnDisk), 10).scene);
  EXPECT_FALSE(Refined(turned(6, "5,0 5,8"), 0.01).scene) << "a hexagonal prism";
}

TEST(RefineScene, LeavesSurfacesWithAnOpenBorderAlone) {
  EXPECT_FALSE(Refined("grid 16 x 1 triangles round: 5*cos(pi*u/8); 5*sin(pi*u/8); 8*v", 0.01).scene);
}

TEST(RefineScene, MovesCornersOnChordsOntoBothSurfaces) {
  constexpr double kMost = 0.02;
  for (const int facets : {24, 30, 48}) {
    const Refined refined("shape csg-plug 25 12.5 " + std::to_string(facets), kMost);
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
  const auto pin = [](const std::string& x, const std::string& z) {
    return "grid 16 x 1 capped triangles round: 5*cos(pi*u/8)+" + x + "; 5*sin(pi*u/8); 20*v+" + z + "\n";
  };
  // A sleeve, whose bore is the pin's wall turned over.
  const auto sleeve = [](const std::string& bore, const std::string& n, const std::string& z) {
    const std::string r = "if(v==1,9,if(v==2,9," + bore + "))";
    return "grid " + n + " x 4 triangles round: " + r + "*cos(2*pi*u/" + n + "); " + r + "*sin(2*pi*u/" + n +
           "); if(abs(v-2.5)<1,15,5)+" + z + "\n";
  };
  const struct {
    const char* name;
    std::string mesh;
    bool refined;
  } rows[] = {{"a pin in its bore", pin("0", "0") + sleeve("5", "16", "0"), false},
              {"a pin in a wider bore", pin("0", "0") + sleeve("7", "16", "0"), true},
              {"bores that continue each other", sleeve("5", "16", "0") + sleeve("5", "24", "10"), true},
              {"two pins in each other", pin("0", "0") + pin("6", "5"), true},
              {"two pins beside each other", pin("0", "0") + pin("12", "0"), true},
              {"two pins that touch", pin("0", "0") + pin("10", "0"), false}};
  for (const auto& row : rows) EXPECT_EQ(Refined(row.mesh, 0.01).scene.has_value(), row.refined) << row.name;
}

[[maybe_unused]] const bool scripts_are_added = add_mesh_scripts(LIGNE_SOURCE_DIR "/tests/patches/scripts");

}  // namespace
}  // namespace ligne::test
