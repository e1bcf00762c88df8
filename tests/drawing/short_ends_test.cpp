/// Lines that end a little before the line that they run into.
#include "drawing/short_ends.hpp"

#include <gtest/gtest.h>

#include "stroke_builder.hpp"

namespace ligne {
namespace {

std::size_t extend(StrokeModel& strokes) {
  return extend_short_ends(strokes, {.reach_mm = 20, .touching_mm = 1}, [](const Stroke&) { return SourceEdge{}; });
}

StrokeModel page_with(std::vector<Stroke> strokes) {
  StrokeModel m;
  m.strokes = std::move(strokes);
  return m;
}

const Stroke kWall = stroke({100, -50}, {100, 50}, LineClass::outline, 1);

TEST(ShortEnds, GoOnToTheLineBeforeThem) {
  StrokeModel m = page_with({stroke({0, 0}, {90, 0}, LineClass::outline, 0), kWall});
  EXPECT_EQ(extend(m), 1u);
  EXPECT_EQ(m.strokes.back().from, (LatticePoint{90, 0}));
  EXPECT_EQ(m.strokes.back().to, (LatticePoint{100, 0}));
  EXPECT_EQ(m.strokes.back().line_class, LineClass::outline);
  EXPECT_EQ(m.intersections.size(), 1u);
}

TEST(ShortEnds, GoOnInTheDirectionOfTheirLine) {
  // The last stroke is too short to tell a direction.
  StrokeModel m =
      page_with({stroke({0, 0}, {90, 0}, LineClass::crease, 0), stroke({90, 0}, {90, 1}, LineClass::crease, 0), kWall});
  EXPECT_EQ(extend(m), 1u);
  EXPECT_NEAR(m.strokes.back().to.y, 2, 1);
}

TEST(ShortEnds, TurnToTheLineBesideWhichTheyEnd) {
  // It comes from afar, so that only one end is near the others.
  const Stroke start = stroke({0, -90}, {60, 0}, LineClass::outline, 0),
               line = stroke({60, 0}, {90, 0}, LineClass::outline, 2);
  StrokeModel beside = page_with({start, line, stroke({50, 4}, {200, 4}, LineClass::outline, 1)});
  EXPECT_EQ(extend(beside), 1u);
  EXPECT_EQ(beside.strokes.back().from, (LatticePoint{90, 0}));
  EXPECT_EQ(beside.strokes.back().to, (LatticePoint{101, 4})) << "by 20 degrees";
  StrokeModel begins = page_with({start, line, stroke({105, 4}, {200, 10}, LineClass::outline, 1)});
  EXPECT_EQ(extend(begins), 1u) << "not once from either end";
  EXPECT_EQ(begins.strokes.back().to, (LatticePoint{105, 4}));
  StrokeModel apart = page_with({start, line, stroke({50, 8}, {200, 8}, LineClass::outline, 1)});
  EXPECT_EQ(extend(apart), 0u);
  StrokeModel behind = page_with({start, line, stroke({50, 4}, {92, 4}, LineClass::outline, 1)});
  EXPECT_EQ(extend(behind), 0u);
  StrokeModel ahead = page_with({start, line, stroke({91, -2}, {109, 2}, LineClass::outline, 1)});
  EXPECT_EQ(extend(ahead), 1u);
  EXPECT_EQ(ahead.strokes.back().to, (LatticePoint{100, 0})) << "straight, where it can";
}

TEST(ShortEnds, StayWhereNothingIsNearOrTheLineIsShort) {
  StrokeModel far = page_with({stroke({0, 0}, {75, 0}, LineClass::outline, 0), kWall});
  EXPECT_EQ(extend(far), 0u);
  StrokeModel brief = page_with({stroke({70, 0}, {88, 0}, LineClass::outline, 0), kWall});
  EXPECT_EQ(extend(brief), 0u);
  StrokeModel meets = page_with({stroke({0, 0}, {99, 0}, LineClass::outline, 0), kWall});
  EXPECT_EQ(extend(meets), 0u);
  StrokeModel corner =
      page_with({stroke({0, 0}, {90, 0}, LineClass::outline, 0), stroke({90, 0}, {90, 30}, LineClass::outline, 2), kWall});
  EXPECT_EQ(extend(corner), 0u);
  StrokeModel mesh = page_with({stroke({0, 0}, {90, 0}, LineClass::mesh, 0), kWall});
  EXPECT_EQ(extend(mesh), 0u);
}

TEST(ShortEnds, CutTheHiddenLineThatTheyGoOnOver) {
  StrokeModel m = page_with(
      {stroke({0, 0}, {90, 0}, LineClass::outline, 0), kWall, hidden(stroke({90, 0}, {190, 0}, LineClass::outline, 0))});
  EXPECT_EQ(extend(m), 1u);
  EXPECT_NEAR(m.strokes[2].from.x, 100, 1.5);
  EXPECT_EQ(m.strokes[2].to.x, 190);
}

}  // namespace
}  // namespace ligne
