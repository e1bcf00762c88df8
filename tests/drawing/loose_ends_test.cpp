/// Lines whose ends lie so near to each other that nothing shows between them.
#include "drawing/loose_ends.hpp"

#include <gtest/gtest.h>

#include "stroke_builder.hpp"

namespace ligne {
namespace {

constexpr auto kCrease = LineClass::crease, kOutline = LineClass::outline;

SourceEdge no_source(const Stroke&) { return {}; }

std::size_t joined(StrokeModel& m) { return join_loose_ends(m, 10, no_source); }

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
  StrokeModel far = model({stroke({0, 0}, {100, 0}, kCrease), stroke({110, 0}, {200, 0}, kCrease)});
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
