#include "drawing/stroke_index.hpp"

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
