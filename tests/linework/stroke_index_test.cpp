#include "linework/overlaps/stroke_index.hpp"
#include "linework/overlaps/stroke_overlap.hpp"
#include "linework/overlaps/stroke_tree.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

// These hold for every index of segments to which insert() and erase() are known, and from which query() finds those that
// may overlap one.

/// The numbers of the segments found, in order, each once.
template <class Index>
std::vector<std::uint32_t> found(Index& index, LatticePoint from, LatticePoint to) {
  std::vector<std::uint32_t> segments;
  index.query(from, to, [&](std::uint32_t s) {
    segments.push_back(s);
    return false;  // there may be more
  });
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  return segments;
}

/// In an empty index.
template <class Index>
void expect_erased_segments_gone(Index& index) {
  const LatticePoint a{0, 0}, b{5000, 0}, c{9000, 0};
  index.insert(a, b);
  EXPECT_EQ(found(index, a, b), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(found(index, {1000, 0}, {2000, 0}), (std::vector<std::uint32_t>{0}));
  index.erase(0);
  EXPECT_TRUE(found(index, a, b).empty());
  EXPECT_TRUE(found(index, {1000, 0}, {2000, 0}).empty());
  EXPECT_TRUE(found(index, {-1000, 0}, c).empty());
  index.insert(b, c);
  index.insert(a, b);
  EXPECT_EQ(found(index, {-1000, 0}, {9500, 0}), (std::vector<std::uint32_t>{1, 2}));
}

/// Segments through one small place, thousands of them, come into an empty index and go: all that overlap within the
/// index's tolerance, in steps, are found.
template <class Index>
void expect_overlaps_found_in_a_crowd(Index& index, double tolerance) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> place(-1500, 1500);
  const auto point = [&] { return LatticePoint{place(random), place(random)}; };
  struct Segment {
    LatticePoint from, to;
    bool erased;
  };
  std::vector<Segment> segments;
  std::size_t overlaps = 0;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const Segment s{point(), point(), false};
    const std::vector<std::uint32_t> near = found(index, s.from, s.to);
    for (std::uint32_t k = 0; k < segments.size(); ++k) {
      const bool is_near = std::binary_search(near.begin(), near.end(), k);
      if (segments[k].erased) {
        EXPECT_FALSE(is_near) << k;
      } else if (overlap(s.from, s.to, segments[k].from, segments[k].to, tolerance)) {
        ++overlaps;
        EXPECT_TRUE(is_near) << k;
      }
    }
    index.insert(s.from, s.to);
    segments.push_back(s);
    if (i % 3 != 0) continue;
    const auto gone = static_cast<std::uint32_t>(random() % segments.size());
    index.erase(gone);
    segments[gone].erased = true;
  }
  EXPECT_GT(overlaps, 500u);
}

constexpr double kOverlapTolerance = 10;

std::optional<StrokeOverlap> test(LatticePoint a0, LatticePoint a1, LatticePoint b0, LatticePoint b1) {
  return overlap(a0, a1, b0, b1, kOverlapTolerance);
}

TEST(StrokeOverlap, IsPartOfBoth) {
  const struct {
    const char* name;
    LatticePoint a0, a1, b0, b1;
    std::array<double, 4> parts;
  } cases[] = {{"part of the other", {0, 0}, {1000, 0}, {250, 0}, {500, 0}, {0.25, 0.5, 0, 1}},
               {"runs the other way", {500, 0}, {250, 0}, {0, 0}, {1000, 0}, {0, 1, 0.5, 0.25}},
               {"parts of both", {0, 0}, {0, 1000}, {0, 1500}, {0, 500}, {0.5, 1, 1, 0.5}}};
  for (const auto& c : cases) {
    const auto o = test(c.a0, c.a1, c.b0, c.b1);
    ASSERT_TRUE(o) << c.name;
    EXPECT_EQ((std::array{o->a_from, o->a_to, o->b_from, o->b_to}), c.parts) << c.name;
  }
}

TEST(StrokeOverlap, NotLongerThanTheTolerance) {
  EXPECT_FALSE(test({0, 0}, {1000, 0}, {990, 0}, {2000, 0}));
  EXPECT_TRUE(test({0, 0}, {1000, 0}, {989, 0}, {2000, 0}));
  EXPECT_FALSE(test({0, 0}, {1000, 0}, {1000, 0}, {2000, 0})) << "end to end";
  EXPECT_FALSE(test({0, 0}, {10, 0}, {0, 0}, {10, 0})) << "as short as the tolerance";
}

TEST(StrokeOverlap, DeviationUpToTheTolerance) {
  EXPECT_TRUE(test({0, 0}, {1000, 0}, {0, 10}, {900, -10}));
  EXPECT_FALSE(test({0, 0}, {1000, 0}, {0, 11}, {900, 11}));
}

TEST(StrokeOverlap, AWedgeDoesNotCoincide) {
  EXPECT_FALSE(test({0, 0}, {100000, 0}, {0, 0}, {100000, 11}));
  EXPECT_FALSE(test({0, 0}, {100000, 0}, {0, 0}, {50000, 11}));
  EXPECT_TRUE(test({0, 0}, {100000, 0}, {0, 0}, {50000, 10})) << "closes again within the tolerance";
  EXPECT_FALSE(test({0, 0}, {1000, 0}, {500, -300}, {500, 300})) << "crossing";
}

TEST(StrokeIndex, WhatIsErasedIsFoundNoMoreAndItsEndsServeOthers) {
  StrokeIndex cells(1000, 10);
  StrokeTree tree(10);
  expect_erased_segments_gone(cells);
  expect_erased_segments_gone(tree);
}

/// So many that cells of the index are refined.
TEST(StrokeIndex, InACrowdAllThatOverlapAreFound) {
  constexpr double kTolerance = 20;
  StrokeIndex cells(2000, kTolerance);
  StrokeTree tree(kTolerance);
  expect_overlaps_found_in_a_crowd(cells, kTolerance);
  expect_overlaps_found_in_a_crowd(tree, kTolerance);
}

/// Half of the lines end where all pass: of the thousands near each of them only those are found that may lie on it.
TEST(StrokeIndex, OfACrowdThroughAPointOnlyThoseThatMayLieOnEachOtherAreFound) {
  constexpr double kTolerance = 20, kRadius = 4e6;
  constexpr std::size_t kLines = 4000;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> direction(-3.1, 3.1);
  std::vector<std::pair<LatticePoint, LatticePoint>> lines;
  StrokeIndex index(1e5, kTolerance);
  std::size_t found = 0, overlapping = 0;
  for (std::size_t i = 0; i < kLines; ++i) {
    const double a = direction(random);
    const auto x = static_cast<std::int32_t>(kRadius * std::cos(a)), y = static_cast<std::int32_t>(kRadius * std::sin(a));
    const LatticePoint from{x, y}, to = i % 2 == 0 ? LatticePoint{0, 0} : LatticePoint{-x, -y};
    index.query(from, to, [&](std::uint32_t) { return ++found, false; });
    for (const auto& [p, q] : lines) overlapping += overlap(from, to, p, q, kTolerance).has_value();
    index.insert(from, to);
    lines.emplace_back(from, to);
  }
  EXPECT_LE(found, 4 * overlapping + kLines) << overlapping << " pairs overlap";
}

TEST(WalkedCell, IsNoHairWhereStrokesAreLong) {
  const std::vector<Stroke> strokes(100, stroke({0, 0}, {3'000'000, 4'000'000}));
  EXPECT_EQ(walked_cell(strokes, 5000), 5000) << "few cells";
  EXPECT_EQ(walked_cell({}, 1e-6), 1e-6);
  for (const double wanted : {1.0, 1e-6}) {
    const SegmentGrid grid(walked_cell(strokes, wanted), wanted);
    std::size_t cells = 0;
    for (const Stroke& s : strokes) grid.walk(s.from, s.to, [&](std::uint64_t) { return ++cells, false; });
    EXPECT_LT(cells, 1'000'000u) << wanted;
    EXPECT_GT(cells, 10'000u) << wanted;
  }
}

/// The comparisons of one segment do not grow with the number of those that cross it or lie beside it.
TEST(StrokeTree, OfThousandsThroughOnePointAndSideBySideFewAreFound) {
  constexpr double kTolerance = 4;
  constexpr int kCount = 20'000, kLength = 1'000'000;
  StrokeTree crossing(kTolerance), beside(kTolerance);
  std::vector<LatticePoint> ends;
  for (int i = 0; i < kCount; ++i) {
    const double angle = std::numbers::pi * i / kCount;
    ends.push_back({static_cast<std::int32_t>(std::lround(kLength * std::cos(angle))),
                    static_cast<std::int32_t>(std::lround(kLength * std::sin(angle)))});
    crossing.insert({-ends.back().x, -ends.back().y}, ends.back());
    beside.insert({20 * i, 0}, {20 * i + i % 7, kLength});
  }
  for (int i = 0; i < kCount; i += 100) {
    const LatticePoint end = ends[static_cast<std::size_t>(i)];
    const auto near_crossing = found(crossing, {-end.x, -end.y}, end);
    EXPECT_TRUE(std::binary_search(near_crossing.begin(), near_crossing.end(), i)) << i;
    EXPECT_LT(near_crossing.size(), 8u) << i;
    const auto near_beside = found(beside, {20 * i, 0}, {20 * i + i % 7, kLength});
    EXPECT_TRUE(std::binary_search(near_beside.begin(), near_beside.end(), i)) << i;
    EXPECT_LT(near_beside.size(), 8u) << i;
  }
}

/// A tree that is filled at once answers as one that was filled one by one.
TEST(StrokeTree, FilledAtOnceItFindsAllThatOverlap) {
  constexpr double kTolerance = 10;
  std::mt19937 random(5);
  std::vector<Stroke> strokes(4000);
  std::vector<std::uint32_t> of;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    const int reach = i % 2 == 0 ? 3000 : 60;  // half of them are short
    std::uniform_int_distribution<int> place(-1500, 1500), away(-reach, reach);
    strokes[i].from = {place(random), place(random)};
    strokes[i].to = {strokes[i].from.x + away(random), strokes[i].from.y + away(random)};
    of.push_back(i);
  }
  const StrokeTree tree(strokes, of, kTolerance);
  std::size_t overlaps = 0;
  for (std::uint32_t i = 0; i < 500; ++i) {
    const std::vector<std::uint32_t> near = found(tree, strokes[i].from, strokes[i].to);
    for (const std::uint32_t k : of) {
      if (!overlap(strokes[i].from, strokes[i].to, strokes[k].from, strokes[k].to, kTolerance)) continue;
      ++overlaps;
      EXPECT_TRUE(std::binary_search(near.begin(), near.end(), k)) << i << ' ' << k;
    }
  }
  EXPECT_GT(overlaps, 1000u);
}

}  // namespace
}  // namespace ligne
