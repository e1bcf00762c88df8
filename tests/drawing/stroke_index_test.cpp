#include "drawing/stroke_index.hpp"

#include "segment_index_checks.hpp"

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

}  // namespace
}  // namespace ligne
