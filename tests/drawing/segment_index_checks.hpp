#pragma once
/// What holds for every index of segments to which insert() and erase() are known, and from which query() finds those that
/// may overlap one.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "drawing/stroke_overlap.hpp"

namespace ligne {

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

}  // namespace ligne
