// Roberts and culling: which scenes they take for convex bodies, against the plain rule in model space; the lines of
// Roberts against those of the default method; how many bodies a line is held against.

#include "base/disjoint_sets.hpp"
#include "report/stroke_difference.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "support/standard_views.hpp"
#include "visibility/common/convex_body.hpp"

namespace ligne::test {
namespace {

VisibilityResult by_roberts(const ProjectedScene& projected, bool hidden = false) {
  VisibilityOptions options;
  options.hidden_strokes = hidden;
  return find_method("roberts")->compute_visibility(projected, options);
}

std::string beyond_roberts(const ProjectedScene& projected) { return by_roberts(projected).unsupported_reason; }

/// Whether no vertex of the faces lies on either side of a triangle of theirs while another lies on the other.
bool all_on_one_side(const Scene& scene, const std::vector<const Triangle*>& triangles) {
  for (const Triangle* t : triangles) {
    const Point3 a = scene.vertices[t->v[0]];
    const Point3 normal = glm::cross(scene.vertices[t->v[1]] - a, scene.vertices[t->v[2]] - a);
    bool above = false, below = false;
    for (const Triangle* other : triangles)
      for (const std::uint32_t v : other->v) {
        const double height = glm::dot(normal, scene.vertices[v] - a);
        above |= height > 0;
        below |= height < 0;
      }
    if (above && below) return false;
  }
  return true;
}

/// No corner of a flat face turns the other way, and it has no holes.
bool is_convex_face(const Scene& scene, std::uint32_t face) {
  if (scene.faces.contour_count(face) != 1) return false;
  const auto corners = scene.faces.contour(face, 0);
  const Point3 normal = face_normal(scene, face);
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 a = scene.vertices[corners[i]], b = scene.vertices[corners[(i + 1) % n]],
                 c = scene.vertices[corners[(i + 2) % n]];
    if (glm::dot(glm::cross(b - a, c - b), normal) < 0) return false;
  }
  return true;
}

/// Closed convex bodies, and single convex faces.
struct ConvexParts {
  std::size_t bodies = 0, faces = 0;
};

/// Counts the sets of faces that hang together by edges of two faces. Nothing where one of them is neither; exact on the
/// corpus, whose coordinates are dyadic.
std::optional<ConvexParts> convex_parts(const Scene& scene) {
  const Topology topology = build_topology(scene);
  DisjointSets sets(scene.faces.size());
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    if (topology.edges[e].face1 != kNone && !(topology.edge_flags[e] & kEdgeManyFaces))
      sets.join(topology.edges[e].face1, topology.edges[e].face0);
  std::map<std::uint32_t, std::vector<const Triangle*>> triangles;
  for (const Triangle& t : topology.triangles) triangles[sets.find(t.face)].push_back(&t);
  std::set<std::uint32_t> open;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const Edge& edge = topology.edges[e];
    if (edge.face1 != kNone && !(topology.edge_flags[e] & (kEdgeManyFaces | kEdgeUnlikeWound))) continue;
    for (const std::uint32_t f : {edge.face0, edge.face1})
      if (f != kNone) open.insert(sets.find(f));
  }
  ConvexParts parts;
  for (const auto& [root, own] : triangles) {
    const bool one_face = std::ranges::all_of(own, [&](const Triangle* t) { return t->face == own[0]->face; });
    if (one_face ? !is_convex_face(scene, own[0]->face) : open.contains(root) || !all_on_one_side(scene, own)) return {};
    ++(one_face ? parts.faces : parts.bodies);
  }
  return parts;
}

using namespace convexity;

std::string beyond_culling(const ProjectedScene& scene) { return why_not_one_convex_body(scene, face_the_viewer(scene)); }

/// Roberts takes convex bodies, culling one of them.
TEST(ConvexBodies, OfTheCorpusAreTakenAndNoOtherScenes) {
  constexpr std::uintmax_t kMostBytes = 20'000;
  // Bodies of one object that meet in an edge of four faces, which the plain rule takes for open; a speck that is a sheet
  // within the tolerance; a face whose triangles are a square beside a spike without area.
  const std::set<std::string> in_doubt{"edge_on_edge_part", "edge_on_edge_whole", "bow_of_two_tetrahedra", "mixed_sizes",
                                       "spike"};
  const std::set<std::string> copies{"cube_stored_twice", "duplicate_objects"};  // left out before culling sees them
  std::array<int, 2> convex{}, one_body{};
  for (const std::filesystem::path& file : corpus_files(kMostBytes)) {
    const std::string name = file.stem().string();
    const Scene scene = scene_of_file(file);
    const std::optional<ConvexParts> parts = convex_parts(scene);
    const bool is_one = copies.contains(name) || (parts && parts->bodies == 1 && parts->faces == 0);
    for (const Point3& direction : {Point3{-1, 2, -1}, Point3{0, 1, 0}, Point3{-0.37, 0.83, -0.41}}) {
      const ProjectedScene page = project_on_a4(scene, along(direction));
      EXPECT_EQ(beyond_culling(page).empty(), is_one) << name << ": " << beyond_culling(page);
      if (in_doubt.contains(name) || direction.x == 0) continue;  // a face that is seen edge on is no part of a body
      EXPECT_EQ(beyond_roberts(page).empty(), parts.has_value()) << name << ": " << beyond_roberts(page);
    }
    ++convex[parts.has_value()];
    ++one_body[is_one];
  }
  EXPECT_GE(*std::ranges::min_element(convex), 40);
  EXPECT_GE(one_body[1], 8);
  EXPECT_GE(one_body[0], 100);
}

Scene a_box() {
  Scene scene;
  add_box(scene, {0, 0, 0}, {10, 10, 10});
  return scene;
}

TEST(ConvexBodies, OthersAreRefusedWithTheReason) {
  const CameraRequest oblique = along({-1, 2, -1});
  const Scene whole = a_box();
  Scene glass = whole, two = whole;
  glass.materials = {{"glass", {0.5, 0.7, 0.9}, 0.4}};
  glass.face_material.assign(6, 0);
  add_box(two, {20, 0, 0}, {10, 10, 10});
  const ProjectedScene box = project_on_a4(whole, oblique), cut = project_on_a4(whole, oblique, "all", 50.0),
                       inside = project_on_a4(whole, from_eye({5, 5, 5}, {9, 5, 5}));
  EXPECT_EQ(beyond_culling(box), "");
  EXPECT_EQ(beyond_culling(cut), "it is not a closed body entirely in view");
  EXPECT_EQ(beyond_culling(inside), "it is not a closed body entirely in view");
  EXPECT_EQ(beyond_culling(project_on_a4(glass, oblique)), "faces are transparent");
  EXPECT_EQ(beyond_culling(project_on_a4(two, oblique)), "it is more than one body");
  EXPECT_EQ(beyond_culling(project_on_a4({}, oblique)), "it has no faces in view");
  EXPECT_EQ(beyond_roberts(box), "");
  expect_parts(beyond_roberts(cut), {"it is not entirely in view"});
  for (const auto& [name, reason] : {std::pair("open_box", "it is not a closed body"),
                                     {"l_block", "it is not convex"},
                                     {"plate_one_hole", "it is a face that is not convex"}})
    expect_parts(beyond_roberts(project_on_a4(corpus_scene(name), oblique)), {reason});
}

/// Two boxes, one behind the other: each hides three of its own edges, and the first hides a part of the second by its
/// silhouette and its planes, without a test of a facet.
TEST(Roberts, DecidesBoxesApartByInequalitiesAlone) {
  Scene scene = a_box();
  add_box(scene, {3, 30, 3}, {10, 10, 10});
  const VisibilityResult result = by_roberts(project_on_a4(scene, along({-1, 4, -1})));
  EXPECT_EQ(result.unsupported_reason, "");
  EXPECT_EQ(count_of(result.statistics, "bodies"), 2u);
  EXPECT_EQ(count_of(result.statistics, "planes of front faces"), 6u);
  EXPECT_EQ(count_of(result.statistics, "sides of silhouettes"), 12u);
  EXPECT_EQ(count_of(result.statistics, "lines behind their own body"), 6u);
  EXPECT_GT(count_of(result.statistics, "behind all planes"), 0u);
  EXPECT_EQ(count_of(result.statistics, "line-facet tests"), 0u);
}

/// A bar of 2 x 2 through a box of 10 x 10 x 10, from above at 10 mm by unit: lines of penetration are drawn, and the bar's
/// edges end at them.
TEST(Roberts, DrawsLinesOfPenetration) {
  Scene scene = a_box();
  add_box(scene, {-4, 4, 4}, {18, 2, 12});
  const PictureRequest request{along({0, 0, -1}), "all", false, 10, "roberts"};
  const Picture above = draw(scene, request);
  // The bar is the upper one: 18 x 2, whole, before the box, of which two sides are cut by it.
  EXPECT_NEAR(above.length(), 10 * (2 * (18 + 2) + 4 * 10 - 2 * 2), 0.01);
  const Picture oblique = draw(scene, {along({-1, 2, -1}), "all", false, 0, "roberts"});
  EXPECT_GT(oblique.length_of(LineClass::intersection), 1);
}

/// Visible and hidden lines of bodies that penetrate each other, that touch, and that have many faces.
TEST(Roberts, DrawsAsTheDefaultMethod) {
  std::vector<std::pair<std::string, Scene>> scenes;
  for (unsigned seed = 0; seed < 6; ++seed)
    scenes.emplace_back("boxes " + std::to_string(seed), random_boxes(40, seed, 5, {4, 2, 1}));
  for (const char* name : {"bricks", "lattice_of_bars", "cubes_stacked_flush", "nested_cubes", "three_prisms_unequal"})
    scenes.emplace_back(name, corpus_scene(name));
  for (const auto& [name, scene] : scenes) {
    for (const CameraRequest& camera :
         {along({-1, 2, -1}), along({-0.37, 0.83, -0.41}), from_eye({30, -40, 25}, {0, 0, 0})}) {
      for (const bool hidden : {false, true}) {
        PictureRequest request{camera, "all", hidden, 0, "roberts"};
        const ProjectedScene projected = project_on_a4(scene, camera);
        if (!beyond_roberts(projected).empty()) continue;
        const Picture roberts = draw(scene, request);
        request.method = "appel";
        const Picture appel = draw(scene, request);
        const StrokeDifference difference = difference_of(roberts.model, appel.model);
        EXPECT_EQ(difference.length_mm, 0) << name << (hidden ? ", hidden too" : "");
      }
    }
  }
}

/// n boxes in each other, and n slats behind each other of each of which a strip is seen: tests grow as n log n.
TEST(Roberts, HoldsALineAgainstFewBodiesInCrowds) {
  const auto tests_by_line = [](const Scene& scene) {
    const VisibilityResult result = by_roberts(project_on_a4(scene, along({0, 1, 0}), "feature"));
    EXPECT_EQ(result.unsupported_reason, "");
    return double(count_of(result.statistics, "line-body tests")) / double(count_of(result.statistics, "candidate edges"));
  };
  for (const int n : {100, 800}) {
    Scene boxes, slats;
    for (int i = 0; i < n; ++i) {
      const double size = 10 + i;
      add_box(boxes, Point3{-size, -size, -size}, Point3{2 * size, 2 * size, 2 * size}, rotation(0.3, 0.2, 0.1));
      add_box(slats, Point3{i * 0.1, i * 2.0, i * 0.1}, Point3{100, 1, 100});
    }
    EXPECT_LT(tests_by_line(boxes), 3 * std::log2(n)) << n;
    EXPECT_LT(tests_by_line(slats), 3 * std::log2(n)) << n;
  }
}

// Culling as a method: front faces and faces seen edge on; lines of no face.

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

/// The line of an axis is drawn only where the body does not hide it.
TEST(Culling, LinesOfNoFace) {
  const Scene box = a_box();
  ProjectedScene scene = project_on_a4(box, along({0, 1, 0}), "all", 5.0);
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
