// The priority list of the method newell: hand-worked orders, tests and cuts, after the figures of [Boulle1980] 2.5.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/parallel.hpp"
#include "study/generators.hpp"
#include "support/scenes.hpp"
#include "visibility/newell/priority_list.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {
namespace {

using newell::Element;
using newell::ListCounts;
using newell::PaintElements;
using newell::PriorityList;
using studies::add_comb;
using studies::add_plate;
using studies::ring;

/// A list and how it came about. The viewer looks along +y: x to the right, z up, what has the larger y is farther.
struct Sorted {
  std::vector<std::uint32_t> faces;  ///< of the elements, the farthest first
  ListCounts counts;
};

Sorted sorted(const Scene& scene, const CameraRequest& camera = along({0, 1, 0})) {
  const Picture picture = draw(scene, {camera, "all", false, 1, "appel"});
  PaintElements elements(picture.projected);
  PriorityList list(elements);
  Sorted result;
  for (const std::uint32_t e : list.sort()) result.faces.push_back(elements[e].face);
  result.counts = list.counts();
  return result;
}

using Order = std::vector<std::uint32_t>;

// Figure 2.72: F1 and F2, in this order: the second hides a part of the first.
TEST(Newell, Figure272) {
  Scene scene;
  add_plate(scene, 0, 6, 0, 6, 5, 5);
  add_plate(scene, 3, 9, 3, 9, 2, 2);
  const Sorted s = sorted(scene);
  EXPECT_EQ(s.faces, (Order{0, 1}));
  EXPECT_EQ(s.counts.slabs, 2u) << "their depths are apart: nothing is compared";
  EXPECT_EQ(s.counts.compared, 0u);
}

// Figure 2.81 a: P has the farther point and hides Q. P: from depth 9 at x = 0 to 1 at x = 10; Q: depth 6, x from 7 to 9,
// where P is at 3.4 to 1.8. Q is moved to the head.
TEST(Newell, Figure281a) {
  Scene scene;
  add_plate(scene, 0, 10, 0, 10, 9, 1);
  add_plate(scene, 7, 9, 3, 6, 6, 6);
  const Sorted s = sorted(scene);
  EXPECT_EQ(s.faces, (Order{1, 0}));
  EXPECT_EQ(s.counts.moved, 1u);
  EXPECT_EQ(s.counts.plane_cuts + s.counts.page_cuts, 0u);
}

// Figure 2.81 b: both reach as far, to 8. The list begins with either; P (0) hides Q at x = 8..9, where it is at 1.6 to 0.8
// and Q, which is level, at 8.
TEST(Newell, Figure281b) {
  Scene scene;
  add_plate(scene, 0, 10, 0, 10, 8, 0);
  add_plate(scene, 8, 9, 3, 6, 8, 8);
  EXPECT_EQ(sorted(scene).faces, (Order{1, 0}));
}

// Figure 2.81 c: they pass through each other along x = 5. One is cut: three elements, the halves of one on both sides of
// the other.
TEST(Newell, Figure281c) {
  Scene scene;
  add_plate(scene, 0, 10, 0, 10, 8, 0);
  add_plate(scene, 0, 10, 2, 8, 0, 8);
  const Sorted s = sorted(scene);
  EXPECT_EQ(s.counts.plane_cuts, 1u);
  EXPECT_EQ(s.counts.page_cuts, 0u);
  ASSERT_EQ(s.faces.size(), 3u);
}

// Figure 2.81 d: mutual overlap of an L and a bar. The L: a column x 0..2, z 0..10, and a foot x 2..10, z 0..2, in the plane
// y = 5. The bar crosses both arms, at z = 8 - x: it passes behind the column (y 8 at x = 0) and before the foot (y 2 at x =
// 8). Its plane cuts the plane of the L at x = 4, where there is nothing of the L: no face is penetrated, but one is cut.
TEST(Newell, Figure281d) {
  Scene scene;
  add_face(scene, {{{0, 5, 0}, {10, 5, 0}, {10, 5, 2}, {2, 5, 2}, {2, 5, 10}, {0, 5, 10}}});
  add_face(scene, {{{-1, 8.75, 8}, {9, 1.25, -1}, {9, 1.25, 1}, {-1, 8.75, 10}}});
  const Sorted s = sorted(scene);
  EXPECT_EQ(s.counts.plane_cuts, 1u);
  EXPECT_EQ(s.faces.size(), 3u);
  // The half behind the L, the L, the half before it; or half of the L, the bar, the other half.
  EXPECT_EQ(s.faces.front(), s.faces.back());
}

// Figure 2.81 e, and larger rings: bar i begins before the end of bar i - 1 and ends behind the begin of bar i + 1. No bar
// is penetrated. Somewhere one has to be cut; where the plane of one passes through another one, that is cut along it,
// though it does not always break the ring. A convex face of c = 4 corners falls into no more than c / 2 + 1 pieces.
TEST(Newell, Figure281eRings) {
  for (int n = 3; n <= 6; ++n) {
    SCOPED_TRACE(n);
    const Sorted s = sorted(ring(n));
    const std::uint64_t cuts = s.counts.plane_cuts + s.counts.page_cuts;
    EXPECT_GE(cuts, 1u);
    EXPECT_EQ(s.faces.size(), static_cast<std::size_t>(n) + cuts);
    for (std::uint32_t f = 0; f < static_cast<std::uint32_t>(n); ++f) {
      EXPECT_LE(std::count(s.faces.begin(), s.faces.end(), f), 3) << "bar " << f;
    }
    // 2.5.2.7: n studies of n - 1 comparisons find the ring. Pairs that do not overlap on the page are not compared here.
    EXPECT_LE(s.counts.compared, (cuts + 1) * static_cast<std::uint64_t>(2 * n * (n - 1)));
  }
}

// Figure 2.83: the depths of all faces are apart, and Q_p is empty for each: nothing is compared.
TEST(Newell, Figure283NothingIsCompared) {
  const Sorted s = sorted(studies::apart_in_depth(20));
  EXPECT_EQ(s.counts.compared, 0u);
  EXPECT_EQ(s.counts.slabs, 20u);
  Order farthest_first(20);
  for (std::uint32_t i = 0; i < 20; ++i) farthest_first[i] = 19 - i;
  EXPECT_EQ(s.faces, farthest_first);
}

// Figure 2.85: a face of r corners that a straight cut divides into the most pieces: r / 2 + 1 at most. A comb of t teeth
// has 4 t corners; a cut through the teeth leaves its back and t points: t + 1 <= r / 2 + 1.
TEST(Newell, Figure285PiecesOfACut) {
  for (int teeth = 1; teeth <= 6; ++teeth) {
    SCOPED_TRACE(teeth);
    Scene scene;
    add_comb(scene, teeth, 5);
    const Picture picture = draw(scene, {along({0, 1, 0}), "all", false, 1, "appel"});
    PaintElements elements(picture.projected);
    EXPECT_EQ(elements.cut(0, {{1, 0, 0}, {6, 0, 0}}).size(), static_cast<std::size_t>(teeth) + 1);
  }
}

// Figure 2.84: every face is in mutual overlap with P, and the sort begins with the wrong one of each pair. P is a plate
// that leans; the combs stand in it with their teeth: each pair needs one cut, and no more than one.
TEST(Newell, Figure284EachFaceIsCutOnceByP) {
  Scene scene;
  add_plate(scene, -1, 11, -1, 40, 0, 12);
  for (int i = 0; i < 3; ++i) {
    const double z = 12 * i;
    add_face(scene, {{{0, 9, z}, {10, 1, z}, {10, 1, z + 2}, {2, 7.4, z + 2}, {2, 7.4, z + 4}, {0, 9, z + 4}}});
  }
  const Sorted s = sorted(scene);
  EXPECT_LE(s.counts.plane_cuts, 3u);
  EXPECT_GE(s.counts.plane_cuts, 1u);
  EXPECT_LE(s.faces.size(), 1u + 3u * 4u);
}

// Figures 2.86 to 2.88: a scene that falls into zones, these into slabs, and these into zones again: each slab holds one
// face in the end, and the study is done without a comparison.
TEST(Newell, Figure288ZonesAndSlabsToTheEnd) {
  Scene scene;
  // Left zone: two slabs; the nearer one is two zones, above each other.
  add_plate(scene, 0, 10, 0, 10, 9, 8);
  add_plate(scene, 0, 10, 0, 4, 3, 2);
  add_plate(scene, 0, 10, 6, 10, 3, 1);
  // Right zone: two slabs.
  add_plate(scene, 20, 30, 0, 10, 9, 1.5);
  add_plate(scene, 20, 30, 2, 8, 0.5, 1);
  const Sorted s = sorted(scene);
  EXPECT_EQ(s.counts.compared, 0u);
  EXPECT_EQ(s.counts.lists, 0u);
  EXPECT_GT(s.counts.zones, 0u);
  EXPECT_GT(s.counts.slabs, 0u);
  const auto place = [&](std::uint32_t f) { return std::find(s.faces.begin(), s.faces.end(), f) - s.faces.begin(); };
  EXPECT_LT(place(0), place(1));
  EXPECT_LT(place(0), place(2));
  EXPECT_LT(place(3), place(4));
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
