// The tree of the method bsp: hand-worked orders and splits, its invariants, and one tree drawn from many viewpoints.

#include "main/tier.hpp"
#include "order_check.hpp"
#include "studies/scenes/generators.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "visibility/bsp/bsp.hpp"
#include "visibility/convex_tree/convex_tree.hpp"

namespace ligne::test {
namespace {

/// A method with a tree that is there: one compilation for many viewpoints.
template <class TreeMethod, class Tree>
class CompiledMethod final : public Method {
 public:
  explicit CompiledMethod(const Tree& tree) : tree_(tree) {}
  const MethodTraits& traits() const override { return method_.traits(); }
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const override {
    return method_.compute_visibility(tree_, scene, options);
  }

 private:
  const Tree& tree_;
  TreeMethod method_;
};

/// Holds against the oracle what one tree of turned boxes, a plate with a hole, and an upright box gives from 100
/// viewpoints, four by four as far from the middle as `reaches` says; every fourth is a parallel view. Returns the tree.
template <class TreeMethod, class Tree>
Tree expect_right_from_100_viewpoints(unsigned seed, int boxes, const Point3& corner, const Point3& size,
                                      const std::array<double, 4>& reaches) {
  Scene scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < boxes; ++i)
    add_box(scene, Point3{u(random), u(random), u(random)} * 2.0, {1.5, 1.0, 2.0},
            rotation(u(random) * 3, u(random) * 3, u(random) * 3));
  add_face(scene, {{{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, {{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}}});
  add_box(scene, corner, size);
  Tree tree(scene, {});
  const CompiledMethod<TreeMethod, Tree> method(tree);
  const Topology topology = build_topology(scene);
  int covered = 0, viewpoints = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    const Point3 eye = Point3{u(random), u(random), u(random)} * reaches[i % 4];
    StandardView view = perspective_view("viewpoint", scene, eye, Point3{u(random), u(random), u(random)}, 60);
    if (i % 4 == 1) {
      view.camera = along(eye);
      view.options = "--direction";
    }
    // Four that follow each other are of all kinds.
    if (!is_chosen("viewpoints of a tree", i / 4, 4)) continue;
    ++viewpoints;
    const JudgedView judged(scene, "viewpoint " + std::to_string(i), view);
    const Verdict verdict = judged.judge(method, "all");
    EXPECT_TRUE(verdict.passes()) << verdict.faults;
    EdgeSelection all;
    all.classes.bits = 0xff;
    const VisibilityResult result = method.compute_visibility(project(scene, topology, judged.view(), all), {});
    const OrderVerdict order = check_order(*result.order, judged.oracle(), static_cast<unsigned>(i), 40);
    EXPECT_EQ(order.faults, "") << "viewpoint " << i;
    covered += order.covered;
  }
  EXPECT_GT(covered, 10 * viewpoints);
  return tree;
}

using studies::ball;

/// An upright plate on the plan, from (x0, y0) to (x1, y1), as two triangles of one face.
void add_wall(Scene& scene, double x0, double y0, double x1, double y1) {
  add_face(scene, {{{x0, y0, 0}, {x1, y1, 0}, {x1, y1, 1}, {x0, y0, 1}}});
}

/// Faces from the farthest to the nearest, by their pieces.
std::vector<std::uint32_t> painted(const BspTree& tree, const Viewpoint& viewpoint) {
  std::vector<std::uint32_t> faces;
  tree.front_to_back(viewpoint, [&](std::uint32_t piece, std::uint32_t) { faces.push_back(tree.pieces().face(piece)); });
  std::reverse(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

Viewpoint eye_at(const Point3& eye) { return {eye, {0, 0, 1}, true}; }
Viewpoint from(const Point3& direction) { return {{0, 0, 0}, direction, false}; }

// The lecture's figure of a display has the caption "1, 2, 5, 3, 4". Walls on the plan, numbered as there; the viewer looks
// along +y. Behind 3 stand 1, 2 and 5, before it 4; of the three 2 divides the others, 1 behind it and 5 before it. Each
// hides a part of the next, so this is the only order; 5 is slanted and begins behind where 3 ends, and reaches farther to
// the viewer than the middle of 2.
//
//   y  6        1------------1
//      4    2---------2
//      3          ___---5
//      1    5---
//      0      3-----------3
//     -2          4-----4
constexpr double kWalls[5][4] = {{2, 6, 8, 6}, {0, 4, 5, 4}, {1, 0, 7, 0}, {3, -2, 6, -2}, {0, 1, 6, 3}};

TEST(Bsp, GivesTheLecturesOrder) {
  Scene scene;
  for (const auto& w : kWalls) add_wall(scene, w[0], w[1], w[2], w[3]);
  for (unsigned candidates : {1u, 2u, 5u, 64u}) {
    const BspTree tree(scene, {candidates});
    const std::vector<std::uint32_t> order{0, 1, 4, 2, 3};
    EXPECT_EQ(painted(tree, eye_at({4, -10, 0.5})), order);
    EXPECT_EQ(painted(tree, from({0, -1, 0})), order);
    // From the other side everything is reversed.
    const std::vector<std::uint32_t> reversed(order.rbegin(), order.rend());
    EXPECT_EQ(painted(tree, eye_at({4, 20, 0.5})), reversed);
    EXPECT_EQ(painted(tree, from({0, 1, 0})), reversed);
  }
}

TEST(Bsp, TakesTheRootOfTheFewestSplits) {
  Scene scene;
  for (const auto& w : kWalls) add_wall(scene, w[0], w[1], w[2], w[3]);
  // The line of 5, y = 1 + x / 3, cuts wall 2 (at x = 9: no) and wall 1 (at x = 15: no): nothing. No other line meets a wall
  // but 5's own, which meets none: five nodes.
  const BspTree tree(scene, {64});
  EXPECT_EQ(tree.counts().splits, 0u);
  EXPECT_EQ(tree.counts().nodes, 5u);
  // A wall across, from (4.5, -1) to (4.5, 5): the lines of 2, 3 and 5 cut it, its own line cuts 1, 2, 3, 4 and 5. With all
  // faces as candidates the roots cut it three times at the most: four pieces, of two triangles each.
  add_wall(scene, 4.5, -1, 4.5, 5);
  const BspTree more(scene, {64});
  EXPECT_GT(more.counts().splits, 0u);
  EXPECT_LE(more.counts().splits, 2u * 3u + 3u) << "a cut meets both triangles, or one on each side of their diagonal";
}

// The plane x = y through a corner of the triangle and the middle of the side across: two halves of three corners, which
// have the corner and the middle in common.
TEST(Bsp, ACutThroughACornerHalvesATriangle) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}});
  ModelPieces pieces(scene);
  const std::uint32_t behind = pieces.cut(0, {glm::normalize(Point3{1, -1, 0}), {0, 0, 0}});
  for (const std::uint32_t piece : {0u, behind}) {
    const auto corners = pieces.corners(piece);
    ASSERT_EQ(corners.size(), 3u);
    const Point3 a = pieces.point(corners[0]), b = pieces.point(corners[1]), c = pieces.point(corners[2]);
    EXPECT_NEAR(glm::length(glm::cross(b - a, c - a)) / 2, 4, 1e-12);
    for (const std::uint32_t corner : corners) {
      const Point3 p = pieces.point(corner);
      EXPECT_GE(piece == 0 ? p.x - p.y : p.y - p.x, -1e-12);
    }
  }
}

TEST(Bsp, CutsOneOfTwoTrianglesThatPassThroughEachOther) {
  const Scene scene = scene_of_faces({{{-4, 0, -4}, {4, 0, -4}, {0, 0, 4}}, {{0, -4, -1}, {0, 4, -1}, {0, 0, 2}}});
  const BspTree tree(scene, {});
  EXPECT_EQ(tree.counts().splits, 1u);
  EXPECT_EQ(tree.pieces().pieces().size(), 3u);
  // Whichever is the root: the half behind it, the root, the half before it.
  const auto order = painted(tree, eye_at({10, -20, 1}));
  ASSERT_EQ(order.size(), 3u);
  EXPECT_EQ(order[0], order[2]);
  EXPECT_NE(order[0], order[1]);
}

TEST(Bsp, KeepsFacesOfOnePlaneInOneNode) {
  Scene scene;
  // The plane x + 2 y + 3 z = 6, faces beside each other and overlapping.
  const auto point = [](double x, double y) { return Point3{x, y, (6 - x - 2 * y) / 3}; };
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 12; ++k)
      add_face(scene,
               {{point(3 * i, 3 * k), point(3 * i + 4, 3 * k), point(3 * i + 4, 3 * k + 3), point(3 * i, 3 * k + 3)}});
  for (const bool free_planes : {true, false}) {
    const BspTree tree(scene, {5, free_planes});
    if (!free_planes) {
      EXPECT_EQ(tree.counts().nodes, 1u);
    }
    EXPECT_EQ(tree.counts().free_planes > 0, tree.counts().nodes > 1);
  }
}

// With planes of faces only, each plane of a ball has all the rest behind it: as deep as there are faces, and neither the
// building nor the walk may need the stack for it.
TEST(Bsp, DeepTreesNeedNoStack) {
  const Scene scene = ball(48);
  const BspTree faces(scene, {1, false});
  EXPECT_EQ(faces.counts().triangles, 2u * 48 * 47);
  EXPECT_EQ(faces.counts().splits, 0u);
  EXPECT_GT(faces.counts().depth, 2000u);
  std::size_t visited = 0;
  faces.front_to_back(eye_at({5, 0, 0}), [&](std::uint32_t, std::uint32_t) { ++visited; });
  EXPECT_EQ(visited, faces.counts().triangles);
  const BspTree mixed(scene, {5, true});
  EXPECT_LT(mixed.counts().depth, 120u);
  EXPECT_LT(mixed.pieces().pieces().size(), 2 * mixed.counts().triangles);
}

TEST(Bsp, OneTreeServesAnyViewpoint) {
  expect_right_from_100_viewpoints<BspMethod, BspTree>(11, 5, {-0.5, -0.5, 0}, {1, 1, 1}, {1, 8, 8, 8});
}

// The display tree of the method convex-tree: the complexities that [Huet1994] states, its measure of termination, and one
// tree displayed from many viewpoints, the eye inside convex sets too.

using studies::stair;

ConvexTree::Counts counts_of(const Scene& scene, const PlaneChoice& options = {}) {
  const ConvexTree tree(scene, options);
  EXPECT_TRUE(tree.counts().terminates);
  return tree.counts();
}

// 3.1: any convex object has complexity 0: one node of type 1.
TEST(ConvexTree, AConvexBodyIsOneConvexSet) {
  Scene box;
  add_box(box, {0, 0, 0}, {1, 2, 3}, rotation(0.3, 0.7, 1.1));
  for (const Scene& body : {box, ball(8), ball(60)}) {
    const ConvexTree::Counts counts = counts_of(body);
    EXPECT_EQ(counts.planes, 0u);
    EXPECT_EQ(counts.convex_sets, 1u);
    EXPECT_EQ(counts.splits, 0u);
    EXPECT_EQ(counts.depth, 1u);
  }
}

// 2.3: objects of convex sets inside each other are displayed without thought: complexity 0.
TEST(ConvexTree, SetsInsideEachOtherNeedNoPlane) {
  Scene scene;
  for (int k = 0; k < 6; ++k) {
    const double size = 10 - k;
    add_box(scene, Point3{-size, -size, -size} / 2.0, {size, size, size});
  }
  const ConvexTree::Counts counts = counts_of(scene);
  EXPECT_EQ(counts.planes, 0u);
  EXPECT_EQ(counts.convex_sets, 6u);
}

// 3.1: "the stair is of complexity 0: n nodes of type 1, n the number of steps". The first and the last face lie on the
// hull, without them the next ones do: each node takes what is outermost at both ends.
TEST(ConvexTree, TheStairHasComplexityZero) {
  for (const int n : {1, 2, 5, 20, 100}) {
    SCOPED_TRACE(n);
    const ConvexTree::Counts counts = counts_of(stair(n), {5, false});
    EXPECT_EQ(counts.planes, 0u);
    EXPECT_EQ(counts.splits, 0u);
    EXPECT_LE(counts.convex_sets, static_cast<std::uint64_t>(n) + 1);
    if (n <= 20) {
      EXPECT_EQ(counts_of(stair(n)).planes, 0u);
    }
  }
}

// Two boxes beside each other: the outer sides of both are on the hull, the two that face each other are a convex set
// inside. A third behind a gap, askew, takes a plane.
TEST(ConvexTree, TwoBoxesBesideEachOther) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {1, 1, 1});
  add_box(scene, {3, 0, 0}, {1, 1, 1});
  const ConvexTree::Counts counts = counts_of(scene);
  EXPECT_EQ(counts.planes, 0u);
  EXPECT_EQ(counts.convex_sets, 2u);
  add_box(scene, {1.2, 4, 0.1}, {1, 1, 1}, rotation(0.4, 0.3, 0.2));
  EXPECT_GE(counts_of(scene).planes, 1u);
}

// 3.3: the number of supporting planes falls, in the whole corpus, whatever planes are chosen.
TEST(ConvexTree, TheMeasureFalls) {
  int scenes = 0;
  for (const std::filesystem::path& file : corpus_files()) {
    SCOPED_TRACE(file.stem());
    const Scene scene = scene_of_file(file);
    counts_of(scene, {1, true});
    counts_of(scene, {5, true});
    if (std::filesystem::file_size(file) < kLargeSceneBytes) counts_of(scene, {5, false});
    ++scenes;
  }
  EXPECT_GT(scenes, 150);
}

TEST(ConvexTree, LargeSetsAreHalved) {
  Scene scene = ball(40);
  const std::size_t corners = scene.vertices.size();
  for (std::size_t v = 0; v < corners; ++v) {
    const Point3 p = scene.vertices[v];
    scene.vertices[v] = p * (1 + 0.1 * std::sin(9 * p.x) * std::cos(7 * p.y));
  }
  const ConvexTree::Counts counts = counts_of(scene);
  EXPECT_LT(counts.depth, 150u);
  EXPECT_LT(counts.splits, 3 * counts.triangles);
}

// Propositions 1 and 2 hold also from inside: every fourth eye is within the boxes' room.
TEST(ConvexTree, OneTreeServesAnyViewpoint) {
  const ConvexTree tree =
      expect_right_from_100_viewpoints<ConvexTreeMethod, ConvexTree>(12, 4, {-4, -4, -4}, {8, 8, 8}, {1, 12, 3.5, 12});
  EXPECT_TRUE(tree.counts().terminates);
}

}  // namespace
}  // namespace ligne::test
