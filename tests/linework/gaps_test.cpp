/// Gaps that are bridged, ends that are led on, and bits of lines that are removed.

#include "drawing/drawing.hpp"
#include "rule_runner.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

std::size_t bridge(StrokeModel& m, const GapLimits& limits) {
  return apply_rule(
      m, 0, [&](LineMap& map) { return bridge_gaps(map, limits, no_source); }, limits.clear_mm);
}
std::size_t joined(StrokeModel& m) { return bridge(m, {100, 250, 50}); }
std::size_t join_far(StrokeModel& m) { return bridge(m, {100, 900, 50}); }
StrokeModel creases(const std::string& text) { return sketch(text, LineClass::crease); }

void expect_last(const StrokeModel& m, LatticePoint from, LatticePoint to) {
  EXPECT_EQ(m.strokes.back().from, from);
  EXPECT_EQ(m.strokes.back().to, to);
}

TEST(Gaps, AreJoined) {
  StrokeModel m = creases("#3 0,0 1000,0; #4 2000,30 1050,20");
  m.edge_count = 10;
  EXPECT_EQ(joined(m), 1u);
  ASSERT_EQ(m.strokes.size(), 3u);
  expect_last(m, {1000, 0}, {1050, 20});
  EXPECT_EQ(m.strokes[2].source, 10u) << "a source of its own";
  EXPECT_EQ(m.intersections.size(), 1u);
  EXPECT_EQ(make_drawing(m).layers.at(0).lines.size(), 1u);
}

TEST(Gaps, TakeTheClassOfTheLongerLine) {
  StrokeModel m = creases("0,0 1000,0; outline 1050,0 3000,0");
  EXPECT_EQ(joined(m), 1u);
  EXPECT_EQ(m.strokes.back().line_class, LineClass::outline);
}

TEST(Gaps, APieceThatFillsTheGapButForRoundingIsJoinedAtBothEnds) {
  StrokeModel m = creases("0,0 10000,0; 9998,1 12001,-1; 12000,0 20000,0");
  EXPECT_EQ(bridge(m, {1000, 2500, 500}), 2u);
  EXPECT_EQ(make_drawing(m).layers.at(0).lines.size(), 1u);
}

TEST(Gaps, OfThreeTheNearestAreJoined) {
  StrokeModel m = creases("0,0 1000,0; 1040,10 2000,10; 1070,-10 2000,-10");
  EXPECT_EQ(joined(m), 1u);
  EXPECT_EQ(m.strokes.back().to, (LatticePoint{1040, 10}));
}

TEST(Gaps, AreJoinedWhereOneLineGoesOn) {
  expect_changes({{"two lines that end beside each other", "0,0 1000,0; 0,50 1000,50", 0},
                  {"a corner", "0,0 1000,0; 1000,50 1000,900", 0},
                  {"another line ends there", "0,0 1000,0; 1050,0 2000,0; outline 1000,0 1000,800", 0},
                  {"the gap shows", "0,0 1000,0; 1250,0 9000,0", 0},
                  {"mesh", "mesh 0,0 1000,0; mesh 1050,0 2000,0", 0},
                  {"where it shows, long lines that go straight on", "0,0 1000,0; 1200,40 3000,120", 1},
                  {"they turn", "0,0 1000,0; 1180,90 3000,900", 0},
                  {"one is short", "700,0 1000,0; 1200,40 3000,120", 0},
                  {"behind a post", "0,0 1000,0; 1200,40 3000,120; outline 1100,-500 1100,500", 0},
                  {"a line ends beside the gap", "0,0 1000,0; 1200,40 3000,120; outline 1100,60 1100,500", 0},
                  {"joints make lines long enough for more", "0,0 1000,0; 1120,0 1370,0; 1570,0 3000,0", 2},
                  {"a speck makes no ring", "0,0 80,0", 0},
                  {"a ring", "0,0 500,0 500,500 0,500; 0,500 0,50 -30,30", 1}},
                 joined, creases);
}

TEST(Gaps, FarApartAreJoinedWhereLongLinesAreStraight) {
  expect_changes({{"straight", "0,0 2000,0; 2400,20 5000,120", 1},
                  {"turning", "0,0 2000,0; 2400,110 5000,300", 0},
                  {"a short line", "600,150 2000,0; 2400,20 5000,120", 0},
                  {"a long line", "0,214 2000,0; 2400,20 5000,120", 1},
                  {"a short piece", "0,0 2000,0; 2400,0 3050,0; 3400,0 6000,0", 0},
                  {"too far apart", "0,0 2000,0; 2650,0 3700,0", 0}},
                 join_far, creases);
}

TEST(Gaps, TheHiddenLineBetweenThemGoes) {
  StrokeModel m = creases("0,0 1000,0; 1200,0 3000,0; hidden 1000,0 1100,-20 1200,0; hidden 1100,-20 1100,900");
  EXPECT_EQ(joined(m), 1u);
  EXPECT_EQ(m.strokes.size(), 4u);
}

// Lines that end a little before the line that they run into.

std::size_t extend(StrokeModel& strokes) {
  const auto rule = [](LineMap& map) { return extend_undershoots(map, {.reach_mm = 20, .touching_mm = 1}, no_source); };
  return apply_rule(strokes, 1, rule, 1);
}

/// Outlines in words, and one before which they end.
StrokeModel before_a_wall(const std::string& text) { return sketch(text + "; #1 100,-50 100,50", LineClass::outline); }

TEST(Undershoots, GoOnToTheLineBeforeThem) {
  StrokeModel m = before_a_wall("0,0 90,0");
  EXPECT_EQ(extend(m), 1u);
  expect_last(m, {90, 0}, {100, 0});
  EXPECT_EQ(m.strokes.back().line_class, LineClass::outline);
  EXPECT_EQ(m.intersections.size(), 1u);
}

TEST(Undershoots, GoOnInTheDirectionOfTheirLine) {
  StrokeModel m = before_a_wall("crease 0,0 90,0 90,1");  // the last stroke is too short to tell a direction
  EXPECT_EQ(extend(m), 1u);
  EXPECT_NEAR(m.strokes.back().to.y, 2, 1);
}

TEST(Undershoots, TurnToTheLineBesideWhichTheyEnd) {
  // It comes from afar, so that only one end is near the others.
  const auto with = [](const std::string& other) {
    return sketch("0,-90 60,0; #2 60,0 90,0; #1 " + other, LineClass::outline);
  };
  StrokeModel beside = with("50,4 200,4");
  EXPECT_EQ(extend(beside), 1u);
  expect_last(beside, {90, 0}, {101, 4});  // by 20 degrees
  StrokeModel begins = with("105,4 200,10");
  EXPECT_EQ(extend(begins), 1u) << "not once from either end";
  EXPECT_EQ(begins.strokes.back().to, (LatticePoint{105, 4}));
  StrokeModel apart = with("50,8 200,8"), behind = with("50,4 92,4");
  EXPECT_EQ(extend(apart), 0u);
  EXPECT_EQ(extend(behind), 0u);
  StrokeModel ahead = with("91,-2 109,2");
  EXPECT_EQ(extend(ahead), 1u);
  EXPECT_EQ(ahead.strokes.back().to, (LatticePoint{100, 0})) << "straight, where it can";
}

TEST(Undershoots, StayWhereNothingIsNearOrTheLineIsShort) {
  expect_changes({{"far", "0,0 75,0", 0},
                  {"short", "70,0 88,0", 0},
                  {"it meets the line", "0,0 99,0", 0},
                  {"a corner", "0,0 90,0; #2 90,0 90,30", 0},
                  {"mesh", "mesh 0,0 90,0", 0}},
                 extend, before_a_wall);
}

TEST(Undershoots, CutTheHiddenLineThatTheyGoOnOver) {
  StrokeModel m = sketch("0,0 90,0; #1 100,-50 100,50; hidden 90,0 190,0", LineClass::outline);
  EXPECT_EQ(extend(m), 1u);
  EXPECT_NEAR(m.strokes[2].from.x, 100, 1.5);
  EXPECT_EQ(m.strokes[2].to.x, 190);
}

/// Bits of lines that are left out.

/// Creases in words, with steps of 1/1000 mm; each source runs from x = 0 to x = 100.
StrokeModel creases_of_100(const std::string& text) {
  StrokeModel m = sketch(text, LineClass::crease, 0.001);
  m.edge_count = 1000;
  for (Stroke& s : m.strokes) {
    s.t_from = m.lattice.to_mm(s.from).x / 100;
    s.t_to = m.lattice.to_mm(s.to).x / 100;
  }
  return m;
}

double visible_mm(const StrokeModel& m) {
  double sum = 0;
  for (const Stroke& s : m.strokes) sum += s.visible ? (s.to.x - s.from.x) / 1000.0 : 0;
  return sum;
}

std::size_t remove_bits(StrokeModel& m, double least_mm) {
  return apply_rule(m, 0, [&](LineMap& map) { return remove_short_bits(map, least_mm); });
}

/// The change of the strokes in words, how many millimetres of them are visible then, and how many strokes there are.
void expect_bits(const std::string& strokes, std::size_t (*change)(StrokeModel&, double), std::size_t changes,
                 double visible, std::size_t count) {
  StrokeModel m = creases_of_100(strokes);
  EXPECT_EQ(change(m, 0.5), changes) << strokes;
  EXPECT_NEAR(visible_mm(m), visible, 1e-9) << strokes;
  EXPECT_EQ(m.strokes.size(), count) << strokes;
}

TEST(ShortBits, ThatVisibilityCutsOffGo) {
  expect_bits("#1 10,0 10.3,0; #2 10,5 10.8,5; #3 0,9 100,9", remove_bits, 1, 100.8, 2);
  expect_bits("hidden #1 0,0 10,0; #1 10,0 10.3,0; hidden #1 10.3,0 100,0", remove_bits, 1, 0, 3);
}

TEST(ShortBits, WhatIsWholeOrJoinsLinesStays) {
  const auto drop = [](double least) { return [=](StrokeModel& m) { return remove_bits(m, least); }; };
  expect_changes({{"one chain counts together", "#1 10,0 10.3,0; #2 10.3,0 10.6,0", 0},
                  {"it ends where two others do", "#1 10,0 10.3,0; #2 10.3,0 60,20; #3 10.3,0 50,0", 0}},
                 drop(0.5), creases_of_100);
  expect_changes({{"a short chain", "#1 10,0 10.3,0; #2 10.3,0 10.6,0", 1}}, drop(0.7), creases_of_100);
  expect_changes({{"an edge that is seen from end to end", "#1 0,0 100,0", 0}}, drop(200), creases_of_100);
}

TEST(ShortBits, IntersectionsByThemselvesGoEvenWhole) {
  StrokeModel m = creases_of_100("#1 0,0 0.3,0; #2 0,5 100,5");
  m.strokes[0].t_to = 1;
  EXPECT_EQ(remove_bits(m, 0.5), 0u);
  m.strokes[0].line_class = LineClass::intersection;
  EXPECT_EQ(remove_bits(m, 0.5), 1u);
}

}  // namespace
}  // namespace ligne
