#include "drawing/stroke_index.hpp"

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "segment_index_checks.hpp"
#include "stroke_builder.hpp"

namespace ligne {
namespace {

TEST(StrokeIndex, WhatIsErasedIsFoundNoMoreAndItsEndsServeOthers) {
  StrokeIndex index(1000, 10);
  expect_erased_segments_gone(index);
}

/// So many that its cells are refined.
TEST(StrokeIndex, InACrowdAllThatOverlapAreFound) {
  constexpr double kTolerance = 20;
  StrokeIndex index(2000, kTolerance);
  expect_overlaps_found_in_a_crowd(index, kTolerance);
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

}  // namespace
}  // namespace ligne
