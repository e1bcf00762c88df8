#include "drawing/stroke_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "drawing/stroke_overlap.hpp"

namespace ligne {
namespace {

std::vector<std::uint32_t> found(StrokeIndex& index, LatticePoint from, LatticePoint to) {
  std::vector<std::uint32_t> segments;
  index.query(from, to, [&](std::uint32_t s) { segments.push_back(s); });
  std::sort(segments.begin(), segments.end());
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  return segments;
}

TEST(StrokeIndex, WhatIsErasedIsFoundNoMoreAndItsEndsServeOthers) {
  StrokeIndex index(1000, 10);
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

/// Segments through one small place, so many that its cells are refined, come and go.
TEST(StrokeIndex, InACrowdAllThatOverlapAreFound) {
  constexpr double kTolerance = 20;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> place(-1500, 1500);
  const auto point = [&] { return LatticePoint{place(random), place(random)}; };
  struct Segment {
    LatticePoint from, to;
    bool erased;
  };
  std::vector<Segment> segments;
  StrokeIndex index(2000, kTolerance);
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

}  // namespace
}  // namespace ligne
