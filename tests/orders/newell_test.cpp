// The priority list of the method newell: its tests, what it never compares, and what it keeps.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/parallel.hpp"
#include "newell_sorted.hpp"
#include "study/generators.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {
namespace {

using newell::PaintElements;
using studies::add_plate;
using studies::ring;

// Plates that overlap in a strip narrower than a step of the lattice: a line on the strip is hidden with it, so they have an
// order. Pieces smaller than a step have none: nothing can be seen of them.
TEST(Newell, NarrowStripsHaveAnOrder) {
  const double step = draw(ring(3), {along({0, 1, 0}), "all", false, 1, "appel"}).projected.lattice.step_mm;
  const auto disjoint = [](double overlap, double size) {
    Scene scene;
    add_plate(scene, 0, 10, 0, 10, 5, 5);
    add_plate(scene, 10 - overlap, 10 - overlap + size, 2, 2 + size, 2, 2);
    const Picture picture = draw(scene, {along({0, 1, 0}), "all", false, 1, "appel"});
    return PaintElements(picture.projected).disjoint(0, 1);
  };
  EXPECT_FALSE(disjoint(10 * step, 5));
  EXPECT_FALSE(disjoint(0.3 * step, 5));
  EXPECT_TRUE(disjoint(0, 5));
  EXPECT_TRUE(disjoint(0.3 * step, 0.6 * step));
}

// 2.5.2.3: tests of rising cost. Two faces whose extents overlap in depth: apart in x, apart in y, one behind the plane of
// the other, before the plane, and disjoint but for their boxes.
TEST(Newell, TestsOfRisingCost) {
  Scene behind;  // both lean alike; the second lies behind the plane of the first all over
  add_plate(behind, 0, 10, 0, 10, 8, 0);
  add_plate(behind, 2, 8, 2, 8, 8.4, 3.6);
  const Sorted s = sorted(behind);
  EXPECT_EQ(s.faces, (Order{1, 0}));
  EXPECT_EQ(s.counts.moved, 0u) << "the second reaches farther";
  EXPECT_EQ(s.counts.behind_plane, 1u);
  EXPECT_EQ(s.counts.projections, 0u);

  Scene corners;  // two triangles of one square: boxes overlap, projections do not
  add_face(corners, {{{0, 0, 0}, {10, 8, 0}, {0, 4, 10}}});
  add_face(corners, {{{10, 3, 9}, {9, 8, 10}, {10, 1, 1}}});
  const Sorted t = sorted(corners);
  EXPECT_EQ(t.counts.plane_cuts + t.counts.page_cuts, 0u);
  EXPECT_EQ(t.counts.depths, 0u);
}

// The order is free of the aspect of faces (2.5.2.6), and siblings, pieces of one face, are never compared: a face with a
// hole is twelve triangles here, of which no two are in one comparison.
TEST(Newell, SiblingsAreNotCompared) {
  Scene scene;
  add_face(scene, {{{0, 0, 0}, {9, 7, 0}, {9, 7, 9}, {0, 0, 9}},
                   {{3, 7.0 / 3, 3}, {3, 7.0 / 3, 6}, {6, 14.0 / 3, 6}, {6, 14.0 / 3, 3}}});
  EXPECT_EQ(sorted(scene).counts.compared, 0u);
  EXPECT_EQ(sorted(scene).faces.size(), 1u);
}

/// Boxes that penetrate each other.
Scene crowd_of_boxes(int count) {
  Scene scene;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < count; ++i) {
    add_box(scene, Point3{u(random), u(random), u(random)} * 4.0, {2, 2, 2}, rotation(u(random) * 3, u(random), u(random)));
  }
  return scene;
}

TEST(Newell, IsTheSameEveryTimeWithAnyNumberOfThreads) {
  const Scene scene = crowd_of_boxes(40);
  const Sorted first = sorted(scene);
  for (const unsigned threads : {1u, 4u}) {
    run_with_threads(threads, [&] {
      const Sorted again = sorted(scene);
      EXPECT_EQ(again.faces, first.faces);
      EXPECT_EQ(again.counts.compared, first.counts.compared);
    });
  }
}

// [Boulle1980], front and back partition: of a box three faces look at the viewer and three do not. Of the 15 pairs the six
// of one kind are never compared, nor is a face at the back with one at the front.
TEST(Newell, FacesOfAConvexBodyAreNotCompared) {
  Scene scene;
  add_box(scene, {0, 0, 0}, {2, 2, 2}, rotation(0.4, 0.5, 0.6));
  const Picture picture = draw(scene, {along({0, 1, 0}), "all", false, 1, "appel"});
  const PaintElements elements(picture.projected);
  EXPECT_EQ(elements.bodies().count(), 1u);
  EXPECT_EQ(elements.bodies().faces(), 6u);
  int never = 0;
  for (std::uint32_t a = 0; a < 6; ++a) {
    for (std::uint32_t b = 0; b < 6; ++b) never += a != b && elements.never_hides(a, b);
  }
  EXPECT_EQ(never, 2 * 6 + 9);
  const Sorted s = sorted(scene);
  EXPECT_LE(s.counts.compared, 9u);
  EXPECT_GT(s.counts.one_body, 0u);
}

// Three strips in a zigzag: the plane of the middle one has the others on both sides.
TEST(Newell, AZigzagIsNoConvexBody) {
  Scene scene;
  begin_object(scene);
  for (const double z : {0.0, 4.0}) {
    for (const Point3& p : {Point3{0, 0, z}, Point3{2, 2, z}, Point3{4, 0, z}, Point3{6, 2, z}}) scene.vertices.push_back(p);
  }
  for (std::uint32_t i = 0; i < 3; ++i) scene.faces.add_face(std::vector<std::uint32_t>{i, i + 1, i + 5, i + 4});
  end_object(scene);
  const Picture picture = draw(scene, {along({0.3, 1, 0}), "all", false, 1, "appel"});
  EXPECT_EQ(PaintElements(picture.projected).bodies().count(), 0u);
}

// The list of a view, with its pieces, is a good beginning for that of a similar one: hardly anything is moved or cut. The
// strokes are the same either way.
TEST(Newell, TakesOverTheListOfASimilarView) {
  const Scene scene = crowd_of_boxes(40);
  const Method& newell = *find_method("newell");
  const auto study = [&](double degrees, const KeptStudy* earlier) {
    const double turn = degrees * std::numbers::pi / 180;
    const Picture picture = draw(scene, {along({std::sin(turn), std::cos(turn), -0.3}), "all", false, 1, "appel"});
    StudyOptions options;
    options.keep = Keep::for_next_view;
    options.earlier = earlier;
    return newell.study(picture.projected, options);
  };
  const auto count = [](const VisibilityResult& result, std::string_view name) {
    const auto& counts = result.statistics.counts;
    return std::ranges::find(counts, name, &std::pair<std::string, std::uint64_t>::first)->second;
  };
  const auto length = [](const VisibilityResult& result) {
    double sum = 0;
    for (const Stroke& s : result.strokes->strokes) sum += std::hypot(double(s.to.x) - s.from.x, double(s.to.y) - s.from.y);
    return sum;
  };
  const VisibilityResult first = study(0, nullptr);
  EXPECT_EQ(count(first, "elements of the view before"), 0u);
  for (const double degrees : {2.0, 5.0}) {
    const VisibilityResult alone = study(degrees, nullptr), next = study(degrees, first.kept.get());
    EXPECT_GT(count(next, "elements of the view before"), 200u);
    EXPECT_LT(2 * count(next, "moved to the head"), count(alone, "moved to the head")) << degrees;
    EXPECT_LT(2 * count(next, "cuts by a plane"), count(alone, "cuts by a plane")) << degrees;
    EXPECT_EQ(next.strokes->strokes.size(), alone.strokes->strokes.size());
    EXPECT_EQ(length(next), length(alone));
  }
  EXPECT_EQ(count(study(90, first.kept.get()), "elements of the view before"), 0u) << "it is another view";
}

}  // namespace
}  // namespace ligne::test
