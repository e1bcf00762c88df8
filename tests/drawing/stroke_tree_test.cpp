#include "drawing/stroke_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "drawing/stroke_overlap.hpp"
#include "segment_index_checks.hpp"

namespace ligne {
namespace {

TEST(StrokeTree, WhatIsErasedIsFoundNoMoreAndItsEndsServeOthers) {
  StrokeTree index(10);
  expect_erased_segments_gone(index);
}

TEST(StrokeTree, InACrowdAllThatOverlapAreFound) {
  constexpr double kTolerance = 20;
  StrokeTree index(kTolerance);
  expect_overlaps_found_in_a_crowd(index, kTolerance);
}

/// What one segment is held against does not grow with what crosses it, nor with what lies beside it.
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
