/// Lines whose ends lie so near to each other that nothing shows between them.
#include "drawing/loose_ends.hpp"

#include <gtest/gtest.h>

#include "stroke_builder.hpp"

namespace ligne {
namespace {

constexpr auto kCrease = LineClass::crease, kOutline = LineClass::outline;

SourceEdge no_source(const Stroke&) { return {}; }

std::size_t joined(StrokeModel& m) { return join_loose_ends(m, {10, 25, 5}, no_source); }

TEST(LooseEnds, AreJoined) {
  StrokeModel m = model({stroke({0, 0}, {100, 0}, kCrease, 3), stroke({200, 3}, {105, 2}, kCrease, 4)});
  m.edge_count = 10;
  EXPECT_EQ(joined(m), 1u);
  ASSERT_EQ(m.strokes.size(), 3u);
  EXPECT_EQ(m.strokes[2].from, (LatticePoint{100, 0}));
  EXPECT_EQ(m.strokes[2].to, (LatticePoint{105, 2}));
  EXPECT_EQ(m.strokes[2].source, 10u) << "a source of its own";
  EXPECT_EQ(m.intersections.size(), 1u);
  EXPECT_EQ(make_drawing(m).layers.at(0).lines.size(), 1u);
}

TEST(LooseEnds, TakeTheClassOfTheLongerLine) {
  StrokeModel m = model({stroke({0, 0}, {100, 0}, kCrease), stroke({105, 0}, {300, 0}, kOutline)});
  EXPECT_EQ(joined(m), 1u);
  EXPECT_EQ(m.strokes.back().line_class, kOutline);
}

TEST(LooseEnds, StayWhereTheLineTurnsAway) {
  StrokeModel back = model({stroke({0, 0}, {100, 0}, kCrease), stroke({0, 5}, {100, 5}, kCrease)});
  EXPECT_EQ(joined(back), 0u) << "two lines that end beside each other";
  StrokeModel corner = model({stroke({0, 0}, {100, 0}, kCrease), stroke({100, 5}, {100, 90}, kCrease)});
  EXPECT_EQ(joined(corner), 0u) << "a corner";
}

TEST(LooseEnds, StayWhereAnotherLineEndsOrTheGapShows) {
  StrokeModel held =
      model({stroke({0, 0}, {100, 0}, kCrease), stroke({105, 0}, {200, 0}, kCrease), stroke({100, 0}, {100, 80}, kOutline)});
  EXPECT_EQ(joined(held), 0u);
  StrokeModel far = model({stroke({0, 0}, {100, 0}, kCrease), stroke({125, 0}, {900, 0}, kCrease)});
  EXPECT_EQ(joined(far), 0u);
  StrokeModel mesh = model({stroke({0, 0}, {100, 0}), stroke({105, 0}, {200, 0})});
  EXPECT_EQ(joined(mesh), 0u);
}

TEST(LooseEnds, OfThreeTheNearestAreJoined) {
  StrokeModel m =
      model({stroke({0, 0}, {100, 0}, kCrease), stroke({104, 1}, {200, 1}, kCrease), stroke({107, -1}, {200, -1}, kCrease)});
  EXPECT_EQ(joined(m), 1u);
  EXPECT_EQ(m.strokes.back().to, (LatticePoint{104, 1}));
}

TEST(LooseEnds, OfLongLinesThatGoStraightOnAreJoinedWhereItShows) {
  const Stroke left = stroke({0, 0}, {100, 0}, kCrease), right = stroke({120, 4}, {300, 12}, kCrease);
  StrokeModel straight = model({left, right});
  EXPECT_EQ(joined(straight), 1u);
  StrokeModel turning = model({left, stroke({118, 9}, {300, 90}, kCrease)});
  EXPECT_EQ(joined(turning), 0u);
  StrokeModel short_line = model({stroke({70, 0}, {100, 0}, kCrease), right});
  EXPECT_EQ(joined(short_line), 0u);
  StrokeModel behind_a_post = model({left, right, stroke({110, -50}, {110, 50}, kOutline)});
  EXPECT_EQ(joined(behind_a_post), 0u);
  StrokeModel beside = model({left, right, stroke({110, 6}, {110, 50}, kOutline)});
  EXPECT_EQ(joined(beside), 0u);
}

TEST(LooseEnds, MakeLinesLongEnoughForMore) {
  StrokeModel m =
      model({stroke({0, 0}, {100, 0}, kCrease), stroke({112, 0}, {137, 0}, kCrease), stroke({157, 0}, {300, 0}, kCrease)});
  EXPECT_EQ(joined(m), 2u);
}

TEST(LooseEnds, OfOneSpeckMakeNoRing) {
  StrokeModel speck = model({stroke({0, 0}, {8, 0}, kCrease)});
  EXPECT_EQ(joined(speck), 0u);
  StrokeModel ring =
      model({stroke({0, 0}, {50, 0}, kCrease), stroke({50, 0}, {50, 50}, kCrease), stroke({50, 50}, {0, 50}, kCrease),
             stroke({0, 50}, {0, 5}, kCrease), stroke({0, 5}, {-3, 3}, kCrease)});
  EXPECT_EQ(joined(ring), 1u);
}

}  // namespace
}  // namespace ligne
