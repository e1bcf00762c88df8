/// Pieces of lines that do not show beside others, and pieces of another class than their line.
#include "drawing/inked_bits.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "drawing/near_part.hpp"
#include "drawing/stroke_chains.hpp"
#include "drawing/stroke_lines.hpp"
#include "geometry/disjoint_sets.hpp"
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

/// What drop_inked_bits() is to find: every bit against every line, every end against every end.
std::vector<Stroke> left_by_all_pairs(const StrokeModel& m, const InkLimits& limits) {
  const StrokeLines lines(m.strokes);
  const auto is_short = [&](std::uint32_t i) { return lines.run(lines.chain_of(i)).length < limits.longest_mm; };
  DisjointSets groups(m.strokes.size());
  for (const std::uint32_t i : lines.seen()) {
    for (const std::uint32_t k : lines.seen()) {
      if (!is_short(i) || !is_short(k)) continue;
      groups.join(i, lines.chain_of(i));
      for (const LatticePoint p : {m.strokes[i].from, m.strokes[i].to}) {
        for (const LatticePoint q : {m.strokes[k].from, m.strokes[k].to}) {
          if (std::hypot(double(p.x) - q.x, double(p.y) - q.y) <= limits.ink_mm) groups.join(i, k);
        }
      }
    }
  }
  std::vector<double> shown(m.strokes.size(), 0);
  std::vector<bool> touches(m.strokes.size(), false);
  for (const std::uint32_t i : lines.seen()) {
    if (!is_short(i)) continue;
    constexpr int kPlaces = 4096;  // along the bit
    std::vector<bool> inked(kPlaces, false);
    for (const std::uint32_t k : lines.seen()) {
      if (is_short(k)) continue;
      const StrokePart part = part_near(m.strokes[i], m.strokes[k], limits.ink_mm);
      for (int place = 0; place < kPlaces; ++place) {
        const double at = (place + 0.5) / kPlaces;
        if (part.from <= at && at <= part.to) inked[place] = true;
      }
      if (!part.empty()) touches[groups.find(i)] = true;
    }
    shown[groups.find(i)] += page_length(m.strokes[i]) * double(std::count(inked.begin(), inked.end(), false)) / kPlaces;
  }
  std::vector<Stroke> left;
  for (std::uint32_t i = 0; i < m.strokes.size(); ++i) {
    const std::uint32_t group = groups.find(i);
    if (!is_short(i) || !touches[group] || shown[group] >= limits.shown_mm) left.push_back(m.strokes[i]);
  }
  return left;
}

TEST(InkedBits, AreThoseOfAllPairs) {
  std::mt19937 random(7);
  std::size_t dropped = 0, kept = 0;
  // A pen that is narrow, and wide, against the lines.
  for (const double ink : {5.0, 17.0, 60.0}) {
    for (int scene = 0; scene < 20; ++scene) {
      const auto number = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
      std::vector<Stroke> strokes;
      for (int i = 0; i < 60; ++i) {
        const LatticePoint p{number(0, 900), number(0, 900)};
        const int reach = i % 6 == 0 ? 500 : 30;
        const LatticePoint q{p.x + number(-reach, reach), p.y + number(-reach, reach)};
        if (p != q) strokes.push_back(stroke(p, q, i % 2 == 0 ? kOutline : kCrease));
      }
      StrokeModel m = model(strokes);
      const InkLimits limits{50, ink, 17};
      const std::vector<Stroke> left = left_by_all_pairs(m, limits);
      drop_inked_bits(m, limits);
      ASSERT_EQ(m.strokes.size(), left.size()) << "ink " << ink << ", scene " << scene;
      for (std::size_t i = 0; i < left.size(); ++i) EXPECT_EQ(m.strokes[i].from, left[i].from);
      dropped += strokes.size() - left.size();
      kept += left.size();
    }
  }
  EXPECT_GT(dropped, 100u);
  EXPECT_GT(kept, 1000u);
}

}  // namespace
}  // namespace ligne
