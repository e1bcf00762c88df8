/// Surfaces that touch: the intersections that clear lines leave out, and those that they keep.

#include "base/no_index.hpp"
#include "drawn_lengths.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/heal/edge_tree.hpp"
#include "scene/heal/segment_cells.hpp"
#include "support/scene_parts.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using test::begin_object;
using test::end_object;

/// A tube without ends round the axis `along`: n flat sides whose edges lie on the cylinder of this radius.
void add_tube(Scene& scene, int n, double radius, const Point3& from, const Point3& along, double turn) {
  begin_object(scene, "tube");
  const Point3 axis = glm::normalize(along);
  const Point3 u = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? Point3{1, 0, 0} : Point3{0, 1, 0}));
  const Point3 v = glm::cross(axis, u);
  const auto base = static_cast<std::uint32_t>(scene.vertices.size());
  for (int i = 0; i < n; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / n;
    const Point3 p = from + radius * (std::cos(angle) * u + std::sin(angle) * v);
    scene.vertices.push_back(p);
    scene.vertices.push_back(p + along);
  }
  const auto m = static_cast<std::uint32_t>(2 * n);
  for (std::uint32_t i = 0; i < m; i += 2) {
    const std::uint32_t next = (i + 2) % m;
    const std::array<std::uint32_t, 4> corners{base + i, base + next, base + next + 1, base + i + 1};
    scene.faces.add_face(corners);
  }
  end_object(scene);
}

/// A plate with a round hole, and the wall of the hole.
void add_bored_plate(Scene& scene, int n, double radius, double depth) {
  begin_object(scene, "plate");
  const auto base = static_cast<std::uint32_t>(scene.vertices.size());
  for (const Point3& p : {Point3{-30, -30, 0}, Point3{30, -30, 0}, Point3{30, 30, 0}, Point3{-30, 30, 0}})
    scene.vertices.push_back(p);
  scene.faces.add_face(std::array{base, base + 1, base + 2, base + 3});
  std::vector<std::uint32_t> hole;
  for (int i = 0; i < n; ++i) {
    const double angle = -2 * std::numbers::pi * i / n;
    hole.push_back(static_cast<std::uint32_t>(scene.vertices.size()));
    scene.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    scene.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), -depth});
  }
  scene.faces.add_hole(hole);
  for (std::size_t i = 0; i < hole.size(); ++i) {
    const std::uint32_t v = hole[i], w = hole[(i + 1) % hole.size()];
    scene.faces.add_face(std::array{w, v, v + 1, w + 1});
  }
  end_object(scene);
}

test::Lengths lengths(const Scene& scene, Quality quality, HiddenLines hidden) {
  PictureRequest request;
  request.lines.quality = quality;
  request.lines.hidden = hidden;
  request.view.up_axis = Axis::z;
  return test::drawn_lengths(scene, request);
}

double intersections_of(const test::Lengths& lengths) { return lengths[static_cast<std::size_t>(LineClass::intersection)]; }

/// Hidden ones too.
double intersections(const Scene& scene, Quality quality) {
  return intersections_of(lengths(scene, quality, HiddenLines::dashed));
}

TEST(Contacts, ChordErrorIsTheHeightOfTheArc) {
  for (const int n : {12, 24, 48, 96}) {
    Scene scene;
    add_tube(scene, n, 10, {0, 0, 0}, {0, 0, 30}, 0.1);
    const FaceNeighbours neighbours(scene, {0, 3});
    const ChordErrors errors(scene, neighbours, {0, 3}, 40);
    const double height = 10 * (1 - std::cos(std::numbers::pi / n));
    EXPECT_NEAR(errors.of(0), height, 1e-6 * height);
    EXPECT_NEAR(errors.of(3), height, 1e-6 * height);
    EXPECT_NEAR(errors.bend(3), 2 * std::numbers::pi / n, 1e-9);
    EXPECT_EQ(ChordErrors(scene, neighbours, {0}, 360.0 / n - 1).of(0), 0) << "creases are no part of a smooth surface";
  }
}

/// A square post with narrow roundings, through a plate that is little wider.
Scene post_in_plate(double half, double rounding, double plate) {
  Scene scene;
  begin_object(scene, "post");
  const auto base = static_cast<std::uint32_t>(scene.vertices.size());
  constexpr int kSteps = 4;
  for (int corner = 0; corner < 4; ++corner)
    for (int i = 0; i <= kSteps; ++i) {
      const double quarter = std::numbers::pi / 2, angle = corner * quarter + i * quarter / kSteps;
      const double middle = corner * quarter + quarter / 2, inner = std::sqrt(2.0) * (half - rounding);
      const Point3 p{inner * std::cos(middle) + rounding * std::cos(angle),
                     inner * std::sin(middle) + rounding * std::sin(angle), -5};
      scene.vertices.push_back(p);
      scene.vertices.push_back(p + Point3{0, 0, 30});
    }
  const auto n = static_cast<std::uint32_t>(scene.vertices.size()) - base;
  for (std::uint32_t i = 0; i < n; i += 2) {
    const std::uint32_t next = (i + 2) % n;
    scene.faces.add_face(std::array{base + i, base + next, base + next + 1, base + i + 1});
  }
  end_object(scene);
  begin_object(scene, "plate");
  const auto first = static_cast<std::uint32_t>(scene.vertices.size());
  for (const int x : {-1, 1})
    for (const int y : {-x, x}) scene.vertices.push_back({x * plate, y * plate, 0});
  scene.faces.add_face(std::array{first, first + 1, first + 2, first + 3});
  end_object(scene);
  return scene;
}

TEST(Contacts, FlatSidesBesideNarrowRoundingsAreNoChords) {
  const Scene scene = post_in_plate(5, 0.3, 5.2);
  const FaceNeighbours neighbours(scene, {0, 4});
  const ChordErrors errors(scene, neighbours, {0, 4}, 40);
  EXPECT_GT(errors.of(4), 0);
  EXPECT_LE(errors.of(4), errors.of(0)) << "the side lies no farther off than the rounding";
  const double exact = intersections(scene, Quality::exact);
  EXPECT_GT(exact, 100);
  EXPECT_NEAR(intersections(scene, Quality::clear), exact, 1e-3 * exact) << "where it stands stays on its own place";
}

TEST(Contacts, APinInItsBoreHasNoIntersections) {
  Scene scene;
  add_tube(scene, 24, 10, {0, 0, 0}, {0, 0, 30}, 0);
  add_tube(scene, 31, 10, {0, 0, -5}, {0, 0, 40}, 0.05);
  EXPECT_GT(intersections(scene, Quality::exact), 500);
  EXPECT_EQ(intersections(scene, Quality::clear), 0);
}

/// Tubes that lie inside each other but for their sag cross at less than their facets bend: a comb of lines along these.
TEST(Contacts, TubesSideBySideHaveNoComb) {
  for (const double aside : {0.1, 0.2, 0.3}) {
    Scene scene;
    add_tube(scene, 64, 10, {0, 0, 0}, {0, 0, 30}, 0);
    add_tube(scene, 71, 10, {aside, 0, -5}, {0, 0, 40}, 0.05);
    EXPECT_GT(intersections(scene, Quality::exact), 100);
    EXPECT_EQ(intersections(scene, Quality::clear), 0) << aside;
  }
  Scene scene;
  add_tube(scene, 64, 10, {0, 0, 0}, {0, 0, 30}, 0);
  add_tube(scene, 71, 10, {4, 0, -5}, {0, 0, 40}, 0.05);
  const double exact = intersections(scene, Quality::exact);
  EXPECT_GT(exact, 50);
  EXPECT_DOUBLE_EQ(intersections(scene, Quality::clear), exact) << "two tubes";
}

/// Where tubes of one radius cross at a right angle they are tangent at two points: the line goes on there.
TEST(Contacts, CrossingTubesKeepTheirWholeLine) {
  for (const double radius : {10.0, 8.0}) {
    Scene scene;
    add_tube(scene, 36, 10, {0, 0, -30}, {0, 0, 60}, 0.03);
    add_tube(scene, 36, radius, {-30, 0, 0}, {60, 0, 0}, 0.02);
    const double exact = intersections(scene, Quality::exact);
    EXPECT_GT(exact, 100);
    EXPECT_DOUBLE_EQ(intersections(scene, Quality::clear), exact) << radius;
  }
}

TEST(Contacts, AFlatFaceThatCutsATubeIsNoContact) {
  Scene scene;
  add_tube(scene, 36, 10, {0, 0, -30}, {0, 0, 60}, 0);
  test::add_face(scene, {{{-20, -20, 1}, {20, -20, 3}, {20, 20, 2}, {-20, 20, 0}}});
  const double exact = intersections(scene, Quality::exact);
  EXPECT_GT(exact, 50);
  EXPECT_DOUBLE_EQ(intersections(scene, Quality::clear), exact);
}

/// The rim of a bore is one line, whatever the triangles of its pin do: what they cut of the face is drawn on the rim.
TEST(Contacts, ARimIsWhole) {
  Scene scene;
  add_bored_plate(scene, 24, 10, 20);
  add_tube(scene, 31, 10, {0, 0, -15}, {0, 0, 40}, 0.05);
  const test::Lengths exact = lengths(scene, Quality::exact, HiddenLines::none);
  const test::Lengths clear = lengths(scene, Quality::clear, HiddenLines::none);
  EXPECT_GT(intersections_of(exact), 20);
  EXPECT_EQ(intersections_of(clear), 0);
  // The outlines of the tube are smooth contours in clear lines, which end elsewhere by a millimetre.
  EXPECT_NEAR(test::length_of_all(clear), test::length_of_all(exact), 0.05 * intersections_of(exact));
}

/// The tree of segments against all segments one by one, and cells of segments against the tree.

std::vector<EdgeTree::Segment> random_segments(std::mt19937& random, std::size_t n) {
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] { return Point3{place(random), place(random), place(random)}; };
  std::vector<EdgeTree::Segment> segments;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 a = point();
    segments.push_back({a, a + 0.1 * point()});
  }
  return segments;
}

TEST(EdgeTree, OfARangeTheNearestIsFoundByTheTreeToo) {
  std::mt19937 random(1);
  const std::vector<EdgeTree::Segment> segments = random_segments(random, 300);
  const EdgeTree tree(segments);
  std::size_t found = 0;
  for (const EdgeTree::Segment& p : random_segments(random, 500)) {
    for (const double distance : {0.05, 0.3, 10.0}) {
      bool several = false;
      const NearestPoint one_by_one = tree.nearest_of(20, 60, p.a, distance, several);
      EXPECT_FALSE(several);
      const NearestPoint by_tree = tree.nearest(p.a, distance, [](std::uint32_t s, double) { return s >= 20 && s < 60; });
      EXPECT_TRUE(one_by_one.segment != kNone || distance < 1);
      // The tree looks at a limited number of segments, so it may find less, and never more.
      if (by_tree.segment == kNone) continue;
      ++found;
      EXPECT_LE(one_by_one.distance, by_tree.distance);
      EXPECT_TRUE(one_by_one.segment != by_tree.segment || one_by_one.at == by_tree.at);
    }
  }
  EXPECT_GT(found, 300u);
}

TEST(SegmentCells, AmongTheSegmentsOfACellTheNearestIsThatOfTheTree) {
  std::mt19937 random(3);
  std::vector<EdgeTree::Segment> segments = random_segments(random, 3000);
  segments.push_back({{-1, -1, -1}, {1, 1, 1}});  // far longer than a cell
  segments.push_back({{1, -1, 0.5}, {1, 1, 0.5}});
  const EdgeTree tree(segments);
  for (const double reach : {0.0, 0.02, 0.04}) {
    const SegmentCells cells(segments, reach);
    std::size_t found = 0, listed = 0;
    for (std::uint32_t own = 0; own < segments.size(); ++own) {
      const auto other = [&](std::uint32_t s, double) { return s != own; };
      for (const Point3& p : {segments[own].a, 0.5 * (segments[own].a + segments[own].b)}) {
        const NearestPoint here = nearest_among(segments, cells.near(p), p, reach, other);
        const NearestPoint anywhere = tree.nearest(p, reach, other);
        EXPECT_EQ(here.segment, anywhere.segment);
        EXPECT_EQ(here.distance, anywhere.distance);
        found += here.segment != kNone;
        listed += cells.near(p).size();
      }
    }
    EXPECT_EQ(found > 300u, reach > 0);
    EXPECT_LT(listed, segments.size() * 100);
  }
}

TEST(SegmentCells, HoldWhatHasNoExtent) {
  const std::vector<EdgeTree::Segment> segments(3, {{5, 5, 5}, {5, 5, 5}});
  const SegmentCells cells(segments, 0);
  EXPECT_EQ(cells.near({5, 5, 5}).size(), 3u);
}

TEST(EdgeTree, TheDistanceItselfIsNearEnough) {
  std::mt19937 random(2);
  const std::vector<EdgeTree::Segment> segments = random_segments(random, 40);
  const EdgeTree tree(segments);
  const auto any = [](std::uint32_t, double) { return true; };
  for (const EdgeTree::Segment& p : random_segments(random, 1000)) {
    const NearestPoint found = tree.nearest(p.a, 10, any);
    EXPECT_EQ(tree.nearest(p.a, found.distance, any).segment, found.segment);
    EXPECT_EQ(tree.nearest(p.a, std::nextafter(found.distance, 0), any).segment, kNone);
  }
}

TEST(EdgeTree, OfEquallyNearSegmentsTheFirstOfARangeIsGiven) {
  const EdgeTree::Segment s{{0, 0, 0}, {1, 0, 0}};
  const EdgeTree tree({s, s, s, s});
  bool several = false;
  const auto nearest = [&](std::uint32_t begin, std::uint32_t end, double distance) {
    return tree.nearest_of(begin, end, {0.25, 2, 0}, distance, several);
  };
  EXPECT_EQ(nearest(1, 4, 3).segment, 1u);
  EXPECT_EQ(nearest(1, 4, 3).at, 0.25);
  EXPECT_TRUE(several);
  EXPECT_EQ(nearest(1, 4, 2).segment, 1u) << "the distance itself is near enough";
  EXPECT_EQ(nearest(2, 3, 3).segment, 2u);
  EXPECT_FALSE(several);
  EXPECT_EQ(nearest(1, 4, 1).segment, kNone);
  EXPECT_EQ(nearest(2, 2, 3).segment, kNone);
}

}  // namespace
}  // namespace ligne
