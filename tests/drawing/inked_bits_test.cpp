/// Pieces of lines that do not show beside others, and pieces of another class than their line.
#include "drawing/inked_bits.hpp"

#include <gtest/gtest.h>

#include "stroke_builder.hpp"

namespace ligne {
namespace {

constexpr auto kCrease = LineClass::crease, kOutline = LineClass::outline;
constexpr InkLimits kLimits{50, 17, 17};  // steps; a pen of about a third of a millimetre with steps of 0.01 mm

TEST(ShortClasses, BecomeThoseOfTheirLine) {
  StrokeModel m = model(
      {stroke({0, 0}, {300, 0}, kOutline), stroke({300, 0}, {320, 5}, kCrease), stroke({320, 5}, {800, 20}, kOutline)});
  EXPECT_EQ(join_short_classes(m, 50), 1u);
  ASSERT_EQ(make_drawing(m).layers.size(), 1u);
  EXPECT_EQ(make_drawing(m).layers[0].lines.size(), 1u);
}

TEST(ShortClasses, GoOnThroughOtherShortOnes) {
  StrokeModel m = model({stroke({0, 0}, {300, 0}, kOutline), stroke({300, 0}, {320, 5}, kCrease),
                         stroke({320, 5}, {330, 9}, LineClass::intersection)});
  EXPECT_EQ(join_short_classes(m, 50), 2u);
  for (const Stroke& s : m.strokes) EXPECT_EQ(s.line_class, kOutline);
}

TEST(ShortClasses, OfARunOfTheClassStay) {
  StrokeModel long_run = model({stroke({0, 0}, {300, 0}, kOutline), stroke({300, 0}, {330, 0}, kCrease),
                                stroke({330, 0}, {360, 0}, kCrease), stroke({360, 0}, {800, 0}, kOutline)});
  EXPECT_EQ(join_short_classes(long_run, 50), 0u) << "together they are long enough";
  StrokeModel branch = model(
      {stroke({0, 0}, {300, 0}, kOutline), stroke({300, 0}, {600, 0}, kOutline), stroke({300, 0}, {300, 40}, kCrease)});
  EXPECT_EQ(join_short_classes(branch, 50), 0u) << "the outline goes on by itself";
  StrokeModel mesh = model({stroke({0, 0}, {300, 0}), stroke({300, 0}, {340, 0}, kCrease)});
  EXPECT_EQ(join_short_classes(mesh, 50), 0u);
}

TEST(InkedBits, SpursBesideALineGo) {
  StrokeModel m = model(
      {stroke({0, 0}, {300, 0}, kOutline), stroke({300, 0}, {600, 0}, kOutline), stroke({300, 0}, {330, 12}, kOutline)});
  EXPECT_EQ(drop_inked_bits(m, kLimits), 1u);
  EXPECT_EQ(m.strokes.size(), 2u);
}

TEST(InkedBits, RungsBetweenLinesThatNearlyTouchGo) {
  StrokeModel m = model(
      {stroke({0, 0}, {300, 0}, kOutline), stroke({0, 45}, {300, 45}, kOutline), stroke({100, 0}, {100, 45}, kCrease)});
  EXPECT_EQ(drop_inked_bits(m, kLimits), 1u);
}

TEST(InkedBits, EdgesSeenEndOnGo) {
  StrokeModel m =
      model({stroke({0, 0}, {300, 0}, kOutline), stroke({300, 0}, {600, 0}, kOutline), stroke({300, 0}, {300, 1}, kCrease)});
  EXPECT_EQ(drop_inked_bits(m, kLimits), 1u);
}

TEST(InkedBits, WhatShowsStays) {
  StrokeModel stub = model({stroke({0, 0}, {600, 0}, kOutline), stroke({300, 0}, {300, 40}, kCrease)});
  EXPECT_EQ(drop_inked_bits(stub, kLimits), 0u) << "23 steps of it show";
  StrokeModel alone = model({stroke({0, 0}, {600, 0}, kOutline), stroke({300, 90}, {300, 100}, kCrease)});
  EXPECT_EQ(drop_inked_bits(alone, kLimits), 0u);
  StrokeModel ring =
      model({stroke({0, 0}, {15, 0}, kOutline), stroke({15, 0}, {0, 12}, kOutline), stroke({0, 12}, {0, 0}, kOutline)});
  EXPECT_EQ(drop_inked_bits(ring, kLimits), 0u) << "a small thing by itself: bits have no ink that hides bits";
}

TEST(InkedBits, ThatMeetCountTogether) {
  StrokeModel m = model({stroke({0, 0}, {600, 0}, kOutline), stroke({300, 0}, {300, 30}, kCrease),
                         stroke({300, 30}, {302, 60}, LineClass::intersection)});
  EXPECT_EQ(drop_inked_bits(m, kLimits), 0u);
}

TEST(InkedBits, BecomeHiddenWhereHiddenLinesAreDrawn) {
  StrokeModel m = model({stroke({0, 0}, {600, 0}, kOutline), stroke({300, 0}, {300, 20}, kCrease),
                         hidden(stroke({0, 80}, {600, 80}, kCrease))});
  EXPECT_EQ(drop_inked_bits(m, kLimits), 1u);
  ASSERT_EQ(m.strokes.size(), 3u);
  EXPECT_FALSE(m.strokes[1].visible);
}

}  // namespace
}  // namespace ligne
