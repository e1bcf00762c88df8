// Culling as a method: which scenes it takes for one convex body, against the plain rule in model space; front faces and
// faces seen edge on; lines of no face.

#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "support/standard_views.hpp"
#include "support/test.hpp"
#include "visibility/common/convex_body.hpp"

namespace ligne::test {
namespace {

using namespace convexity;

std::string beyond(const ProjectedScene& scene) { return why_not_one_convex_body(scene, face_the_viewer(scene)); }

/// Copies are left out before the method sees them.
bool has_copies(const std::filesystem::path& file) {
  return file.stem() == "cube_stored_twice" || file.stem() == "duplicate_objects";
}

/// One object, closed, and no vertex before the plane of a face: exact on the corpus, whose coordinates are dyadic.
bool is_one_convex_body(const Scene& scene, const Topology& topology) {
  if (topology.edges.empty() || scene.objects.size() != 1) return false;
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    if (topology.edges[e].face1 == kNone || (topology.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound))) return false;
  int side_of_all = 0;
  for (const Triangle& t : topology.triangles) {
    const Point3 a = scene.vertices[t.v[0]];
    const Point3 normal = glm::cross(scene.vertices[t.v[1]] - a, scene.vertices[t.v[2]] - a);
    for (const Triangle& other : topology.triangles)
      for (const std::uint32_t v : other.v) {
        const double height = glm::dot(normal, scene.vertices[v] - a);
        if (height == 0) continue;
        const int side = height > 0 ? 1 : -1;
        if (side_of_all == 0) side_of_all = side;
        if (side != side_of_all) return false;
      }
  }
  return side_of_all != 0;
}

TEST(Culling, TakesTheConvexBodiesOfTheCorpusAndNoOthers) {
  constexpr std::uintmax_t kMostBytes = 20'000;
  int convex = 0, others = 0;
  for (const std::filesystem::path& file : corpus_files(kMostBytes)) {
    const Scene scene = scene_of_file(file);
    const bool expected = has_copies(file) || is_one_convex_body(scene, build_topology(scene));
    for (const Point3& direction : {Point3{-1, 2, -1}, Point3{0, 1, 0}, Point3{-0.37, 0.83, -0.41}}) {
      const std::string why = beyond(project_on_a4(scene, along(direction)));
      EXPECT_EQ(why.empty(), expected) << file.stem() << ": " << why;
    }
    ++(expected ? convex : others);
  }
  EXPECT_GE(convex, 8);
  EXPECT_GE(others, 100);
}

Scene a_box() {
  Scene scene;
  add_box(scene, {0, 0, 0}, {10, 10, 10});
  return scene;
}

TEST(Culling, DrawsTheEdgesOfFrontFaces) {
  const Scene box = a_box();
  const VisibilityResult oblique = find_method("culling")->compute_visibility(project_on_a4(box, along({-1, 2, -1})), {});
  EXPECT_EQ(oblique.unsupported_reason, "");
  EXPECT_EQ(oblique.strokes->strokes.size(), 9u);
  EXPECT_EQ(count_of(oblique.statistics, "front faces"), 3u);
  EXPECT_EQ(count_of(oblique.statistics, "back faces, left out"), 3u);
  const VisibilityResult front = find_method("culling")->compute_visibility(project_on_a4(box, along({0, 1, 0})), {});
  EXPECT_EQ(front.strokes->strokes.size(), 4u);
  EXPECT_EQ(count_of(front.statistics, "front faces"), 1u);
  EXPECT_EQ(count_of(front.statistics, "faces seen edge on, left out"), 4u);
}

TEST(Culling, SaysWhyASceneIsBeyondIt) {
  const Scene box = a_box();
  EXPECT_EQ(beyond(project_on_a4(box, along({-1, 2, -1}))), "");
  EXPECT_EQ(beyond(project_on_a4(box, along({-1, 2, -1}), "all", 50.0)), "it is not a closed body entirely in view");
  EXPECT_EQ(beyond(project_on_a4(box, from_eye({5, 5, 5}, {9, 5, 5}))), "it is not a closed body entirely in view");
  Scene glass = box;
  glass.materials = {{"glass", {0.5, 0.7, 0.9}, 0.4}};
  glass.face_material.assign(6, 0);
  EXPECT_EQ(beyond(project_on_a4(glass, along({-1, 2, -1}))), "faces are transparent");
  Scene two = box;
  add_box(two, {20, 0, 0}, {10, 10, 10});
  EXPECT_EQ(beyond(project_on_a4(two, along({-1, 2, -1}))), "it is more than one body");
  EXPECT_EQ(beyond(project_on_a4({}, along({-1, 2, -1}))), "it has no faces in view");
}

/// The line of an axis is drawn only where the body does not hide it.
TEST(Culling, LinesOfNoFace) {
  ProjectedScene scene = project_on_a4(a_box(), along({0, 1, 0}), "all", 5.0);
  const std::vector<std::array<Point3, 2>> behind{{Point3{-5, 20, 5}, Point3{15, 20, 5}}};
  add_lines(scene, behind, LineClass::axes);
  double visible = 0;
  const VisibilityResult result = find_method("culling")->compute_visibility(scene, {});
  for (const Stroke& s : result.strokes->strokes)
    if (s.line_class == LineClass::axes) visible += s.t_to - s.t_from;
  EXPECT_NEAR(visible, 0.5, 1e-6);
}

}  // namespace
}  // namespace ligne::test
