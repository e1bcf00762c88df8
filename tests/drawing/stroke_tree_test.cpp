#include "drawing/stroke_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "drawing/stroke_overlap.hpp"

namespace ligne {
namespace {

std::vector<std::uint32_t> found(const StrokeTree& index, LatticePoint from, LatticePoint to) {
  std::vector<std::uint32_t> segments;
  index.query(from, to, [&](std::uint32_t s) {
    segments.push_back(s);
    return false;
  });
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  return segments;
}

TEST(StrokeTree, WhatIsErasedIsFoundNoMoreAndItsEndsServeOthers) {
  StrokeTree index(10);
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

/// Segments through one small place, many of them, come and go.
TEST(StrokeTree, InACrowdAllThatOverlapAreFound) {
  constexpr double kTolerance = 20;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> place(-1500, 1500);
  const auto point = [&] { return LatticePoint{place(random), place(random)}; };
  struct Segment {
    LatticePoint from, to;
    bool erased;
  };
  std::vector<Segment> segments;
  StrokeTree index(kTolerance);
  std::size_t overlaps = 0;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const Segment s{point(), point(), false};
    const std::vector<std::uint32_t> near = found(index, s.from, s.to);
    for (std::uint32_t k = 0; k < segments.size(); ++k) {
      const bool is_near = std::binary_search(near.begin(), near.end(), k);
      if (segments[k].erased) {
        EXPECT_FALSE(is_near) << k;
      } else if (overlap(s.from, s.to, segments[k].from, segments[k].to, kTolerance)) {
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
