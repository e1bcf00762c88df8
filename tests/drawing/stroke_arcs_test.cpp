#include "drawing/stroke_arcs.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "stroke_builder.hpp"

namespace ligne {
namespace {

constexpr double kArcTolerance = 2;

std::vector<StrokeArc> arcs(const std::vector<Stroke>& strokes) {
  std::vector<std::uint32_t> all(strokes.size());
  std::iota(all.begin(), all.end(), 0u);
  return stroke_arcs(strokes, all, kArcTolerance);
}

/// Every part begins where the one before ends.
void expect_connected(const StrokeArc& arc) {
  for (std::size_t i = 1; i < arc.parts.size(); ++i) {
    const ArcPart &a = arc.parts[i - 1], &b = arc.parts[i];
    EXPECT_EQ(a.reversed ? a.p_from : a.p_to, b.reversed ? b.p_to : b.p_from);
  }
}

TEST(StrokeArcs, ALineOfManyStrokesIsOneArc) {
  const auto found = arcs({stroke({200, 0}, {100, 50}), stroke({0, 0}, {100, 50}), stroke({200, 0}, {300, 0})});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].parts.size(), 3u);
  EXPECT_FALSE(found[0].closed);
  expect_connected(found[0]);
}

TEST(StrokeArcs, ARingWithoutAJunctionIsClosed) {
  const auto found = arcs({stroke({0, 0}, {100, 0}), stroke({100, 100}, {100, 0}), stroke({0, 0}, {100, 100})});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].closed);
  EXPECT_EQ(found[0].parts.size(), 3u);
  expect_connected(found[0]);
}

TEST(StrokeArcs, EndAtJunctions) {
  // Three meet in a point; a fourth ends on the middle of one of them, a step beside it.
  const auto found = arcs({stroke({0, 0}, {1000, 0}), stroke({1000, 0}, {1500, 500}), stroke({1000, 0}, {1500, -500}),
                           stroke({400, 1}, {400, 600})});
  ASSERT_EQ(found.size(), 5u);
  for (const StrokeArc& arc : found) EXPECT_EQ(arc.parts.size(), 1u);
  double cut = 0;
  for (const StrokeArc& arc : found) {
    if (arc.parts[0].stroke == 0 && arc.parts[0].from == 0) cut = arc.parts[0].to;
  }
  EXPECT_NEAR(cut, 0.4, 1e-9);
}

TEST(StrokeArcs, EndWhereALineEndsBesideACorner) {
  const auto found = arcs({stroke({0, 0}, {1000, 0}), stroke({1000, 0}, {2000, 300}), stroke({1001, -1}, {1400, -700})});
  EXPECT_EQ(found.size(), 3u);
}

TEST(StrokeArcs, EndAtCrossings) {
  const auto found = arcs({stroke({0, 0}, {1000, 0}), stroke({250, -500}, {250, 500})});
  ASSERT_EQ(found.size(), 4u);
  for (const StrokeArc& arc : found) {
    const ArcPart& part = arc.parts[0];
    EXPECT_TRUE(part.p_from == (LatticePoint{250, 0}) || part.p_to == (LatticePoint{250, 0}));
  }
}

TEST(StrokeArcs, WhatPassesIsNoJunction) {
  EXPECT_EQ(arcs({stroke({0, 0}, {1000, 0}), stroke({500, 10}, {500, 500})}).size(), 2u) << "an end beside it";
  EXPECT_TRUE(arcs({stroke({5, 5}, {5, 5})}).empty());
}

}  // namespace
}  // namespace ligne
