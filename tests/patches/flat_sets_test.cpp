/// Planes and surfaces of coordinates that are coarse for their facets.

#include "patches/patch_scenes.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/patches/facet_graph.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using namespace test;

/// The scene of polygons whose coordinates were rounded to whole steps.
Scene rounded_scene(std::vector<Corners> polygons, double step) {
  for (Corners& polygon : polygons) {
    for (Point3& p : polygon)
      p = {step * std::round(p.x / step), step * std::round(p.y / step), step * std::round(p.z / step)};
  }
  Scene scene = scene_of(polygons);
  scene.objects[0].precision = step / 2;
  return scene;
}

/// A slanting tube, closed by two rings, of triangles.
std::vector<Corners> tube(int sides, double radius) {
  const Point3 axis = glm::normalize(Point3(0.3, -0.2, 1)), side = glm::normalize(glm::cross(axis, Point3(1, 0, 0)));
  const Point3 other = glm::cross(axis, side);
  const auto point = [&](double r, int u, double z) {
    const double angle = 2 * kPi * (u % sides) / sides;
    return r * std::cos(angle) * side + r * std::sin(angle) * other + z * axis;
  };
  std::vector<Corners> polygons;
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius, u, 3 * v); });
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius * (1 - 0.5 * v), u, 3); });
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius * (0.5 + 0.5 * v), u, 0); });
  add_grid(polygons, sides, 1, true, [&](int u, int v) { return point(radius / 2, u, 3 - 3 * v); });
  return polygons;
}

std::size_t count_creases(const Scene& scene) {
  const Creases creases = find_creases(scene, build_topology(scene), {30, kSurfaceCreaseDegrees});
  return static_cast<std::size_t>(std::count(creases.lines.begin(), creases.lines.end(), kCreaseLine));
}

/// The facets of the one object of a scene.
FacetGraph facets_of(const Scene& scene) {
  const Topology topology = build_topology(scene);
  const auto [begin, end] = edges_of(topology, scene.objects[0]);
  return facet_graph(scene, topology, scene.objects[0], begin, end, face_normals(scene, topology));
}

/// Numbers of faces of the facets of more than two, descending.
std::vector<std::size_t> large_facets(const FacetGraph& graph) {
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (graph.faces[i].size() > 2) sizes.push_back(graph.faces[i].size());
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

class FineTubes : public testing::TestWithParam<int> {};

TEST_P(FineTubes, HaveTwoPlanesWhateverTheRounding) {
  const auto sides = static_cast<std::size_t>(GetParam());
  const Scene scene = rounded_scene(tube(GetParam(), 3.5), 0.001);
  EXPECT_EQ(large_facets(facets_of(scene)), (std::vector<std::size_t>{2 * sides, 2 * sides}));
  EXPECT_EQ(FoundPatches(scene).count(PatchEdge::tangent), 0u);
  EXPECT_EQ(count_creases(scene), 4 * sides);
}

INSTANTIATE_TEST_SUITE_P(Sides, FineTubes, testing::Values(40, 160, 250, 400));

TEST(FlatSets, PlanesHaveNoLinesWhereRoundingTurnsTheirFaces) {
  // A slanting square in strips that are hardly wider than the step.
  std::vector<Corners> polygons;
  add_grid(polygons, 60, 4, true, [](int u, int v) {
    const double x = 0.03 * u + 0.05 * (u / 10), y = 2.5 * v;
    return Point3(x, y, 0.37 * x + 0.21 * y);
  });
  const FoundPatches found(rounded_scene(polygons, 0.01));
  EXPECT_TRUE(found.faces().empty());
  EXPECT_FALSE(found.patches.plane_edges.empty());
  EXPECT_EQ(found.count(PatchEdge::tangent) + found.count(PatchEdge::sharp), 0u);
  EXPECT_EQ(count_creases(found.scene), 0u);
}

TEST(FlatSets, PlanesBesideFineFilletsStayWhole) {
  for (const int steps : {8, 16, 32}) {
    const FacetGraph graph = facets_of(rounded_scene(rounded_box({4, 3, 2.5}, steps), 0.001));
    std::size_t planes = 0;
    for (std::size_t i = 0; i < graph.size(); ++i) planes += graph.area[i] > 4;
    EXPECT_EQ(planes, 6u) << steps;
  }
}

TEST(FlatSets, DoNotDependOnTheOrderOfFaces) {
  for (const int sides : {100, 250, 600}) {
    const std::vector<Corners> polygons = tube(sides, 3.5);
    const std::vector<Corners> turned(polygons.rbegin(), polygons.rend());
    const FacetGraph graph = facets_of(rounded_scene(polygons, 0.001)), again = facets_of(rounded_scene(turned, 0.001));
    EXPECT_EQ(graph.size(), again.size()) << sides;
    EXPECT_EQ(large_facets(graph), large_facets(again)) << sides;
  }
}

}  // namespace
}  // namespace ligne
