// Parts that stand several times in one place, exactly or nearly: they are studied once, and drawn as one.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "drawing/drawing.hpp"
#include "scene/clean/clean.hpp"
#include "support/scene_parts.hpp"
#include "support/scenes.hpp"
#include "view/tolerances.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {
namespace {

const Rect kSheet{{0, 0}, {297, 210}};
const Frame kFrame{{{10, 10}, {287, 200}}};

ProjectedScene projected(const Scene& scene, const char* edges = "all") {
  const View view = make_view(scene, make_camera({}, scene), kFrame, kSheet);
  return project(scene, build_topology(scene), view, {classes(edges), 30});
}

void add_pyramid(Scene& scene) {
  const Point3 top{0.5, 0.5, 1}, a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0}, d{0, 1, 0};
  begin_object(scene);
  const auto first = static_cast<std::uint32_t>(scene.vertices.size());
  for (const Point3& p : {a, b, c, d, top}) scene.vertices.push_back(p);
  scene.faces.add_face(std::vector<std::uint32_t>{first + 3, first + 2, first + 1, first});
  for (std::uint32_t k = 0; k < 4; ++k) scene.faces.add_triangle(first + k, first + (k + 1) % 4, first + 4);
  end_object(scene);
}

using Line = std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t, LineClass, bool>;

std::multiset<Line> lines_of(const Scene& scene, const Method& method) {
  const ProjectedScene p = projected(scene, "feature");
  StudyOptions options;
  options.hidden_strokes = true;
  VisibilityResult result = method.study(p, options);
  std::multiset<Line> lines;
  if (!result.strokes) return lines;
  remove_coincident_strokes(*result.strokes, coincidence_mm(p));
  for (const Stroke& s : result.strokes->strokes) {
    const auto [a, b] = std::minmax(std::pair(s.from.x, s.from.y), std::pair(s.to.x, s.to.y));
    lines.insert({a.first, a.second, b.first, b.second, s.line_class, s.visible});
  }
  return lines;
}

TEST(Coincident, CopiesAreStudiedOnce) {
  Scene one, many;
  add_box(one, {0, 0, 0}, {1, 1, 1});
  for (int i = 0; i < 5; ++i) add_box(many, {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(projected(many).triangles.size(), projected(one).triangles.size());
  EXPECT_EQ(projected(many).edges.size(), projected(one).edges.size());
  for (const ProjectedEdge& edge : projected(many).edges) {
    EXPECT_LT(edge.face0, 6u) << "the first copy stands for all";
    EXPECT_LT(edge.face1, 6u);
  }
}

TEST(Coincident, CopiesAreDrawnAsOneByEveryMethod) {
  Scene one, many;
  for (int i = 0; i < 7; ++i) {
    Scene& scene = many;
    add_pyramid(scene);
    add_box(scene, {0.25, -1, 0.125}, {0.5, 3, 0.25});
  }
  add_pyramid(one);
  add_box(one, {0.25, -1, 0.125}, {0.5, 3, 0.25});
  for (const Method* method : all_methods())
    EXPECT_EQ(lines_of(many, *method), lines_of(one, *method)) << method->traits().name;
}

TEST(Coincident, EveryTransparentPaneStays) {
  Scene scene;
  Material pane;
  pane.opacity = 0.5;
  scene.materials.push_back(pane);
  for (int i = 0; i < 3; ++i) add_face(scene, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}});
  scene.face_material.assign(scene.faces.size(), 0);
  const ProjectedScene p = projected(scene);
  EXPECT_EQ(p.triangles.size(), 6u);
  EXPECT_EQ(p.edges.size(), 4u);
}

TEST(Coincident, FacesThatShareSomeTrianglesStay) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}});
  const Topology topology = build_topology(scene);
  const auto& t = topology.triangles.front().v;
  add_face(scene, {{scene.vertices[t[0]], scene.vertices[t[1]], scene.vertices[t[2]]}});
  EXPECT_EQ(projected(scene).triangles.size(), 3u);
}

TEST(Coincident, TheLineOfTheHigherPrecedenceStays) {
  Scene scene;  // a border of a face along a crease of a box
  add_box(scene, {0, 0, 0}, {1, 1, 1});
  add_face(scene, {{{0, 0, 1}, {0, 0, 2}, {1, 0, 2}, {1, 0, 1}}});
  int there = 0;
  const ProjectedScene p = projected(scene, "all");
  const auto at = [&](std::uint32_t v, const Point3& q) {
    const glm::dvec4 h = p.view.model_to_page * glm::dvec4(q, 1);
    return p.vertices[v].p == p.lattice.snap({h.x / h.w, h.y / h.w});
  };
  for (const ProjectedEdge& e : p.edges) {
    const bool same = (at(e.v0, {0, 0, 1}) && at(e.v1, {1, 0, 1})) || (at(e.v1, {0, 0, 1}) && at(e.v0, {1, 0, 1}));
    if (!same) continue;
    ++there;
    EXPECT_EQ(e.line_class, LineClass::border);
  }
  EXPECT_EQ(there, 1);
}

/// Cubes within much less than the tolerance of each other, wherever their corners lie among the squares of the page, are
/// one cube.
TEST(Coincident, ACrowdOfNearlyEqualCubesIsOne) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> offset(-1e-8, 1e-8);
  Scene one, crowd;
  add_box(one, {0, 0, 0}, {1, 1, 1});
  for (int i = 0; i < 200; ++i) add_box(crowd, {offset(random), offset(random), offset(random)}, {1, 1, 1});
  const ProjectedScene p = projected(crowd);
  EXPECT_EQ(p.triangles.size(), 12u);
  EXPECT_EQ(p.edges.size(), projected(one).edges.size());
  const Method* appel = find_method("appel");
  ASSERT_NE(appel, nullptr);
  EXPECT_EQ(lines_of(crowd, *appel).size(), lines_of(one, *appel).size());
}

TEST(Coincident, AFewNearlyEqualCubesStayAsTheyAre) {
  Scene scene;
  for (int i = 0; i < 3; ++i) add_box(scene, {i * 1e-8, 0, 0}, {1, 1, 1});
  EXPECT_EQ(projected(scene).triangles.size(), 36u);
}

}  // namespace
}  // namespace ligne::test
