/// Surfaces that touch: what tells contacts from intersections. The drawings: cli/scripts/contacts.txt.

#include "base/no_index.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/heal/edge_tree.hpp"
#include "scene/heal/segment_cells.hpp"
#include "support/mesh_text.hpp"
#include "support/scene_parts.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

TEST(Contacts, ChordErrorIsTheHeightOfTheArc) {
  for (const std::uint32_t n : {12u, 24u, 48u, 96u}) {
    const std::string angle = "0.1+2*pi*u/" + std::to_string(n);
    const Scene scene =
        test::mesh_of("grid " + std::to_string(n) + " x 1 round: 10*cos(" + angle + "); 10*sin(" + angle + "); 30*v\nexact")
            .scene();
    const FaceNeighbours neighbours(scene, {0, 3});
    const ChordErrors errors(scene, neighbours, {0, 3}, 40);
    const double height = 10 * (1 - std::cos(std::numbers::pi / n));
    EXPECT_NEAR(errors.of(0), height, 1e-6 * height);
    EXPECT_NEAR(errors.of(3), height, 1e-6 * height);
    EXPECT_NEAR(errors.bend(3), 2 * std::numbers::pi / n, 1e-9);
    EXPECT_EQ(ChordErrors(scene, neighbours, {0}, 360.0 / n - 1).of(0), 0) << "creases are no part of a smooth surface";
  }
}

/// A square post with narrow roundings. What is drawn of it: cli/scripts/contacts.txt.
TEST(Contacts, FlatSidesBesideNarrowRoundingsAreNoChords) {
  const Scene scene = test::mesh_of(
                          "grid 20 x 1 round: "
                          "sqrt(2)*4.7*cos(pi/2*(floor(u/5)+0.5))+0.3*cos(pi/2*(floor(u/5)+mod(u,5)/4));"
                          "sqrt(2)*4.7*sin(pi/2*(floor(u/5)+0.5))+0.3*sin(pi/2*(floor(u/5)+mod(u,5)/4)); 30*v\nexact")
                          .scene();
  const FaceNeighbours neighbours(scene, {0, 4});
  const ChordErrors errors(scene, neighbours, {0, 4}, 40);
  EXPECT_GT(errors.of(4), 0);
  EXPECT_LE(errors.of(4), errors.of(0)) << "the side lies no farther off than the rounding";
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
