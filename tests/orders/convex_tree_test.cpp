// The display tree of the method convex-tree: the complexities that [Huet1994] states, its measure of termination, and one
// tree displayed from many viewpoints, the eye inside convex sets too.

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "compiled_method.hpp"
#include "order_check.hpp"
#include "study/generators.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "visibility/convex_tree/convex_tree_method.hpp"

namespace ligne::test {
namespace {

using studies::ball;
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
  Scene scene;
  std::mt19937 random(12);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 4; ++i) {
    add_box(scene, Point3{u(random), u(random), u(random)} * 2.0, {1.5, 1.0, 2.0},
            rotation(u(random) * 3, u(random) * 3, u(random) * 3));
  }
  add_face(scene, {{{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, {{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}}});
  add_box(scene, {-4, -4, -4}, {8, 8, 8});
  const ConvexTree tree(scene, {});
  EXPECT_TRUE(tree.counts().terminates);
  const CompiledMethod<ConvexTreeMethod, ConvexTree> method(tree);
  const Topology topology = build_topology(scene);
  int covered = 0;
  for (int i = 0; i < 100; ++i) {
    const Point3 eye = Point3{u(random), u(random), u(random)} * (i % 4 == 0 ? 1.0 : i % 4 == 2 ? 3.5 : 12.0);
    StandardView view = perspective_view("viewpoint", scene, eye, Point3{u(random), u(random), u(random)}, 60);
    if (i % 4 == 1) {
      view.camera = along(eye);
      view.options = "--direction";
    }
    const JudgedView judged(scene, "viewpoint " + std::to_string(i), view);
    const Verdict verdict = judged.judge(method, "all");
    EXPECT_TRUE(verdict.passes()) << verdict.faults;
    EdgeSelection all;
    all.classes.bits = 0xff;
    const VisibilityResult result = method.study(project(scene, topology, judged.view(), all), {});
    const OrderVerdict order = check_order(*result.order, judged.oracle(), static_cast<unsigned>(i), 40);
    EXPECT_EQ(order.faults, "") << "viewpoint " << i;
    covered += order.covered;
  }
  EXPECT_GT(covered, 1000);
}

}  // namespace
}  // namespace ligne::test
