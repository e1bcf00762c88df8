/// Lines whose ends lie so near to each other that nothing shows between them.
#include "drawing/loose_ends.hpp"

#include <gtest/gtest.h>

#include "stroke_builder.hpp"

namespace ligne {
namespace {

constexpr auto kCreaseClass = LineClass::crease, kOutlineClass = LineClass::outline;

SourceEdge no_source(const Stroke&) { return {}; }

std::size_t joined(StrokeModel& m) { return join_loose_ends(m, {100, 250, 50}, no_source); }

std::size_t join_far(StrokeModel& m) { return join_loose_ends(m, {100, 900, 50}, no_source); }

TEST(LooseEnds, AreJoined) {
  StrokeModel m = model({stroke({0, 0}, {1000, 0}, kCreaseClass, 3), stroke({2000, 30}, {1050, 20}, kCreaseClass, 4)});
  m.edge_count = 10;
  EXPECT_EQ(joined(m), 1u);
  ASSERT_EQ(m.strokes.size(), 3u);
  EXPECT_EQ(m.strokes[2].from, (LatticePoint{1000, 0}));
  EXPECT_EQ(m.strokes[2].to, (LatticePoint{1050, 20}));
  EXPECT_EQ(m.strokes[2].source, 10u) << "a source of its own";
  EXPECT_EQ(m.intersections.size(), 1u);
  EXPECT_EQ(make_drawing(m).layers.at(0).lines.size(), 1u);
}

TEST(LooseEnds, TakeTheClassOfTheLongerLine) {
  StrokeModel m = model({stroke({0, 0}, {1000, 0}, kCreaseClass), stroke({1050, 0}, {3000, 0}, kOutlineClass)});
  EXPECT_EQ(joined(m), 1u);
  EXPECT_EQ(m.strokes.back().line_class, kOutlineClass);
}

TEST(LooseEnds, APieceThatFillsTheGapButForRoundingIsJoinedAtBothEnds) {
  StrokeModel m = model({stroke({0, 0}, {10'000, 0}, kCreaseClass), stroke({9'998, 1}, {12'001, -1}, kCreaseClass),
                         stroke({12'000, 0}, {20'000, 0}, kCreaseClass)});
  EXPECT_EQ(join_loose_ends(m, {1000, 2500, 500}, no_source), 2u);
  EXPECT_EQ(make_drawing(m).layers.at(0).lines.size(), 1u);
}

TEST(LooseEnds, StayWhereTheLineTurnsAway) {
  StrokeModel back = model({stroke({0, 0}, {1000, 0}, kCreaseClass), stroke({0, 50}, {1000, 50}, kCreaseClass)});
  EXPECT_EQ(joined(back), 0u) << "two lines that end beside each other";
  StrokeModel corner = model({stroke({0, 0}, {1000, 0}, kCreaseClass), stroke({1000, 50}, {1000, 900}, kCreaseClass)});
  EXPECT_EQ(joined(corner), 0u) << "a corner";
}

TEST(LooseEnds, StayWhereAnotherLineEndsOrTheGapShows) {
  StrokeModel held = model({stroke({0, 0}, {1000, 0}, kCreaseClass), stroke({1050, 0}, {2000, 0}, kCreaseClass),
                            stroke({1000, 0}, {1000, 800}, kOutlineClass)});
  EXPECT_EQ(joined(held), 0u);
  StrokeModel far = model({stroke({0, 0}, {1000, 0}, kCreaseClass), stroke({1250, 0}, {9000, 0}, kCreaseClass)});
  EXPECT_EQ(joined(far), 0u);
  StrokeModel mesh = model({stroke({0, 0}, {1000, 0}), stroke({1050, 0}, {2000, 0})});
  EXPECT_EQ(joined(mesh), 0u);
}

TEST(LooseEnds, OfThreeTheNearestAreJoined) {
  StrokeModel m = model({stroke({0, 0}, {1000, 0}, kCreaseClass), stroke({1040, 10}, {2000, 10}, kCreaseClass),
                         stroke({1070, -10}, {2000, -10}, kCreaseClass)});
  EXPECT_EQ(joined(m), 1u);
  EXPECT_EQ(m.strokes.back().to, (LatticePoint{1040, 10}));
}

TEST(LooseEnds, OfLongLinesThatGoStraightOnAreJoinedWhereItShows) {
  const Stroke left = stroke({0, 0}, {1000, 0}, kCreaseClass), right = stroke({1200, 40}, {3000, 120}, kCreaseClass);
  StrokeModel straight = model({left, right});
  EXPECT_EQ(joined(straight), 1u);
  StrokeModel turning = model({left, stroke({1180, 90}, {3000, 900}, kCreaseClass)});
  EXPECT_EQ(joined(turning), 0u);
  StrokeModel short_line = model({stroke({700, 0}, {1000, 0}, kCreaseClass), right});
  EXPECT_EQ(joined(short_line), 0u);
  StrokeModel behind_a_post = model({left, right, stroke({1100, -500}, {1100, 500}, kOutlineClass)});
  EXPECT_EQ(joined(behind_a_post), 0u);
  StrokeModel beside = model({left, right, stroke({1100, 60}, {1100, 500}, kOutlineClass)});
  EXPECT_EQ(joined(beside), 0u);
}

TEST(LooseEnds, FarApartAreJoinedWhereLongLinesAreStraight) {
  const Stroke left = stroke({0, 0}, {2000, 0}, kCreaseClass), right = stroke({2400, 20}, {5000, 120}, kCreaseClass);
  StrokeModel straight = model({left, right});
  EXPECT_EQ(join_far(straight), 1u);
  StrokeModel turning = model({left, stroke({2400, 110}, {5000, 300}, kCreaseClass)});
  EXPECT_EQ(join_far(turning), 0u);
  StrokeModel short_line = model({stroke({600, 150}, {2000, 0}, kCreaseClass), right});
  EXPECT_EQ(join_far(short_line), 0u);
  StrokeModel long_line = model({stroke({0, 214}, {2000, 0}, kCreaseClass), right});
  EXPECT_EQ(join_far(long_line), 1u);
}

TEST(LooseEnds, OfARowOfPiecesAreJoined) {
  const Stroke left = stroke({0, 0}, {2000, 0}, kCreaseClass), right = stroke({3400, 0}, {6000, 0}, kCreaseClass);
  StrokeModel row = model({left, stroke({2400, 0}, {3050, 10}, kCreaseClass), right});
  EXPECT_EQ(join_far(row), 2u);
  StrokeModel off_line = model({left, stroke({2400, 40}, {3050, 40}, kCreaseClass), right});
  EXPECT_EQ(join_far(off_line), 0u);
  StrokeModel short_piece = model({left, stroke({2400, 0}, {2950, 0}, kCreaseClass), right});
  EXPECT_EQ(join_far(short_piece), 0u);
  StrokeModel far_apart = model({left, stroke({2650, 0}, {3700, 0}, kCreaseClass)});
  EXPECT_EQ(join_far(far_apart), 0u);
}

TEST(LooseEnds, MakeLinesLongEnoughForMore) {
  StrokeModel m = model({stroke({0, 0}, {1000, 0}, kCreaseClass), stroke({1120, 0}, {1370, 0}, kCreaseClass),
                         stroke({1570, 0}, {3000, 0}, kCreaseClass)});
  EXPECT_EQ(joined(m), 2u);
}

TEST(LooseEnds, TheHiddenLineBetweenThemGoes) {
  StrokeModel m =
      model({stroke({0, 0}, {1000, 0}, kCreaseClass), stroke({1200, 0}, {3000, 0}, kCreaseClass),
             hidden(stroke({1000, 0}, {1100, -20}, kCreaseClass)), hidden(stroke({1100, -20}, {1200, 0}, kCreaseClass)),
             hidden(stroke({1100, -20}, {1100, 900}, kCreaseClass))});
  EXPECT_EQ(joined(m), 1u);
  EXPECT_EQ(m.strokes.size(), 4u);
}

TEST(LooseEnds, OfOneSpeckMakeNoRing) {
  StrokeModel speck = model({stroke({0, 0}, {80, 0}, kCreaseClass)});
  EXPECT_EQ(joined(speck), 0u);
  StrokeModel ring = model({stroke({0, 0}, {500, 0}, kCreaseClass), stroke({500, 0}, {500, 500}, kCreaseClass),
                            stroke({500, 500}, {0, 500}, kCreaseClass), stroke({0, 500}, {0, 50}, kCreaseClass),
                            stroke({0, 50}, {-30, 30}, kCreaseClass)});
  EXPECT_EQ(joined(ring), 1u);
}

}  // namespace
}  // namespace ligne
