// Which faces are back faces is worked out by hand; and leaving them out changes no drawing of solids.

#include "view/cull.hpp"
#include "main/script.hpp"
#include "support/mesh_text.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

BackFaces back_faces(const Scene& scene, const CameraRequest& request = along({-1, 2, -1})) {
  return find_back_faces(scene, build_topology(scene), view_on_a4(scene, request));
}

Scene box() {
  Scene scene;
  add_box(scene, {0, 0, 0}, {10, 10, 10});
  return scene;
}

/// For culls/solids.txt: "X,Y,Z LINES", the faces of a mesh in the order of its lines, seen along that direction. The culled
/// ones are 1; then the objects that keep theirs.
std::string culled(const std::string& text) {
  const std::size_t space = text.find(' ');
  const Scene scene = mesh_of(text.substr(space + 1)).scene();
  const BackFaces found = back_faces(scene, along(point_of(text.substr(0, space))));
  std::string faces;
  for (const std::uint8_t face : found.culled) faces += face ? '1' : '0';
  EXPECT_EQ(found.faces, static_cast<std::size_t>(std::ranges::count(faces, '1')));
  return faces + " kept " + std::to_string(found.kept_objects) + " of " + std::to_string(scene.objects.size());
}

[[maybe_unused]] const bool culls_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/view/culls", {{"culled", culled}});

TEST(Cull, TransparentShellsKeepTheirFaces) {
  Scene scene = box();
  add_box(scene, {2, 2, 2}, {5, 5, 5});
  scene.materials = {{"plain", {0.8, 0.8, 0.8}, 1}, {"glass", {0.5, 0.7, 0.9}, 0.4}};
  scene.face_material = {1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(back_faces(scene).culled, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0}))
      << "the opaque box has an opaque face of its own before each of its back faces, wherever it stands";
  EXPECT_EQ(back_faces(scene).kept_objects, 1u);
  scene.face_material = {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(back_faces(scene).kept_objects, 1u) << "a glass lid";
}

TEST(Cull, NothingIsLeftOutAroundTheEye) {
  Scene scene = box();
  add_box(scene, {40, 0, 0}, {10, 10, 10});
  const BackFaces inside = back_faces(scene, from_eye({5, 5, 5}, {45, 5, 5}));
  EXPECT_EQ(inside.kept_objects, 1u);
  EXPECT_EQ(inside.culled, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 1}));
  // The near plane, 0.05 before the eye, cuts the first box open.
  EXPECT_EQ(back_faces(scene, from_eye({-0.04, 5, 5}, {49.96, 5, 5})).kept_objects, 1u);
  EXPECT_EQ(back_faces(scene, from_eye({-0.1, 5, 5}, {49.9, 5, 5})).kept_objects, 0u);
}

TEST(Cull, EdgesBetweenTwoBackFacesGo) {
  const Scene scene = box();
  const Topology topology = build_topology(scene);
  const View view = view_on_a4(scene, along({-1, 2, -1}));
  ProjectedScene projected = project(scene, topology, view, {classes("all"), 30});
  ASSERT_EQ(projected.edges.size(), 12u);
  ASSERT_EQ(projected.triangles.size(), 12u);
  cull(projected, find_back_faces(scene, topology, view));
  EXPECT_EQ(projected.edges.size(), 9u);
  EXPECT_EQ(projected.triangles.size(), 6u);
  EXPECT_EQ(std::count_if(projected.edges.begin(), projected.edges.end(),
                          [](const ProjectedEdge& e) { return e.line_class == LineClass::outline; }),
            6);
}

TEST(Cull, ClippedEdgesKeepTheirParts) {
  const Scene scene = box();
  const Topology topology = build_topology(scene);
  const Camera camera = make_camera(along({-1, 2, -1}), scene);
  const View view = make_view(scene, camera, {{{0, 0}, {100, 100}}}, {{0, 0}, {50, 100}});
  ProjectedScene projected = project(scene, topology, view, {classes("all"), 30});
  std::vector<std::pair<std::uint32_t, std::array<double, 2>>> expected;
  const BackFaces back = find_back_faces(scene, topology, view);
  for (std::size_t e = 0; e < projected.edges.size(); ++e) {
    const ProjectedEdge& edge = projected.edges[e];
    if (!back.culled[edge.face0] || !back.culled[edge.face1]) expected.emplace_back(edge.source, projected.edge_parts[e]);
  }
  ASSERT_LT(expected.size(), projected.edges.size());
  cull(projected, back);
  ASSERT_EQ(projected.edges.size(), expected.size());
  ASSERT_EQ(projected.edge_parts.size(), expected.size());
  for (std::size_t e = 0; e < expected.size(); ++e) {
    EXPECT_EQ(projected.edges[e].source, expected[e].first);
    EXPECT_EQ(projected.edge_parts[e], expected[e].second);
  }
}

// That culling changes no drawing: CullDrawing, all_methods_test.cpp.

// Parts that stand several times in one place, exactly or nearly: they are studied once, and drawn as one.

ProjectedScene projected(const Scene& scene, const char* edges = "all") { return project_on_a4(scene, {}, edges); }

using Line = std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t, LineClass, bool>;

std::multiset<Line> lines_of(const Scene& scene, const Method& method) {
  const ProjectedScene p = projected(scene, "feature");
  VisibilityOptions options;
  options.hidden_strokes = true;
  VisibilityResult result = method.compute_visibility(p, options);
  std::multiset<Line> lines;
  if (!result.strokes) return lines;
  remove_coincident_strokes(*result.strokes, coincidence_mm(p));
  for (const Stroke& s : result.strokes->strokes) {
    const auto [a, b] = std::minmax({std::pair(s.from.x, s.from.y), std::pair(s.to.x, s.to.y)});
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
  const auto copies = [](int n) {
    std::string text;
    for (int i = 0; i < n; ++i)
      text +=
          "object\nface 0,1,0 1,1,0 1,0,0 0,0,0\nface 0,0,0 1,0,0 .5,.5,1\nface 1,0,0 1,1,0 .5,.5,1\nface 1,1,0 0,1,0 .5,.5,1\n"
          "face 0,1,0 0,0,0 .5,.5,1\nobject\nbox 0.25,-1,0.125 0.5,3,0.25\n";
    return mesh_of(text).scene();
  };
  for (const Method* method : all_methods())
    EXPECT_EQ(lines_of(copies(7), *method), lines_of(copies(1), *method)) << method->traits().name;
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
  Scene few;
  for (int i = 0; i < 3; ++i) add_box(few, {i * 1e-8, 0, 0}, {1, 1, 1});
  EXPECT_EQ(projected(few).triangles.size(), 36u) << "a few stay as they are";
}

}  // namespace
}  // namespace ligne::test
