/// Pieces of lines that do not show beside others, and pieces of another class than their line.

#include "drawing/cleanup/inked_bits.hpp"
#include "base/disjoint_sets.hpp"
#include "drawing/cleanup/smooth_lines.hpp"
#include "drawing/graphs/stroke_chains.hpp"
#include "drawing/graphs/stroke_lines.hpp"
#include "drawing/near_part.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

constexpr auto kCrease = LineClass::crease, kOutline = LineClass::outline;
constexpr InkLimits kLimits{50, 17, 17};  // steps; a pen of about a third of a millimetre with steps of 0.01 mm

StrokeModel outlines(const std::string& text) { return sketch(text, kOutline); }

TEST(ShortClasses, BecomeThoseOfTheirLine) {
  StrokeModel m = outlines("0,0 300,0; crease 300,0 320,5; 320,5 800,20");
  EXPECT_EQ(join_short_classes(m, 50), 1u);
  ASSERT_EQ(make_drawing(m).layers.size(), 1u);
  EXPECT_EQ(make_drawing(m).layers[0].lines.size(), 1u);
}

TEST(ShortClasses, GoOnThroughOtherShortOnes) {
  StrokeModel m = outlines("0,0 300,0; crease 300,0 320,5; intersection 320,5 330,9");
  EXPECT_EQ(join_short_classes(m, 50), 2u);
  for (const Stroke& s : m.strokes) EXPECT_EQ(s.line_class, kOutline);
}

TEST(ShortClasses, OfARunOfTheClassStay) {
  expect_changes(
      {{"together they are long enough", "0,0 300,0; crease 300,0 330,0 360,0; 360,0 800,0", 0},
       {"the outline goes on by itself", "0,0 300,0 600,0; crease 300,0 300,40", 0},
       {"mesh", "mesh 0,0 300,0; crease 300,0 340,0", 0}},
      [](StrokeModel& m) { return join_short_classes(m, 50); }, outlines);
}

TEST(InkedBits, AreWhatTheInkOfOtherLinesHides) {
  expect_changes(
      {{"rungs between lines that nearly touch go", "0,0 300,0; 0,45 300,45; crease 100,0 100,45", 1},
       {"edges seen end on go", "0,0 300,0 600,0; crease 300,0 300,1", 1},
       {"23 steps of it show", "0,0 600,0; crease 300,0 300,40", 0},
       {"alone", "0,0 600,0; crease 300,90 300,100", 0},
       {"a small thing by itself: bits have no ink that hides bits", "0,0 15,0 0,12 0,0", 0},
       {"bits that meet count together", "0,0 600,0; crease 300,0 300,30; intersection 300,30 302,60", 0}},
      [](StrokeModel& m) { return drop_inked_bits(m, kLimits); }, outlines);
  StrokeModel spur = outlines("0,0 300,0 600,0; 300,0 330,12");
  EXPECT_EQ(drop_inked_bits(spur, kLimits), 1u);
  EXPECT_EQ(spur.strokes.size(), 2u);
}

TEST(InkedBits, BecomeHiddenWhereHiddenLinesAreDrawn) {
  StrokeModel m = outlines("0,0 600,0; crease 300,0 300,20; hidden crease 0,80 600,80");
  EXPECT_EQ(drop_inked_bits(m, kLimits), 1u);
  ASSERT_EQ(m.strokes.size(), 3u);
  EXPECT_FALSE(m.strokes[1].visible);
}

/// A plain search for the same: every bit against every line, every end against every end.
std::vector<Stroke> left_by_all_pairs(const StrokeModel& m, const InkLimits& limits) {
  const StrokeLines lines(m.strokes);
  const auto is_short = [&](std::uint32_t i) { return lines.run(lines.chain_of(i)).length < limits.longest_mm; };
  DisjointSets groups(m.strokes.size());
  for (const std::uint32_t i : lines.seen())
    for (const std::uint32_t k : lines.seen()) {
      if (!is_short(i) || !is_short(k)) continue;
      groups.join(i, lines.chain_of(i));
      for (const LatticePoint p : {m.strokes[i].from, m.strokes[i].to}) {
        for (const LatticePoint q : {m.strokes[k].from, m.strokes[k].to})
          if (std::hypot(double(p.x) - q.x, double(p.y) - q.y) <= limits.ink_mm) groups.join(i, k);
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

// Lines along the edges of scans, drawn as one smooth line.

constexpr std::uint32_t kScan = 1, kOther = 2;

std::size_t smooth(StrokeModel& drawing) {
  return smooth_lines(drawing, [](const Stroke& s) { return s.source == kScan; });
}

/// From one point to the next, every other stroke backwards.
std::vector<Stroke> strokes_along(const std::vector<LatticePoint>& points, std::uint32_t source = kScan) {
  std::vector<Stroke> strokes;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    strokes.push_back(stroke(points[i], points[i + 1], LineClass::crease, source));
    if (i % 2 == 1) std::swap(strokes.back().from, strokes.back().to);
  }
  return strokes;
}

/// Along x in steps of 1000, 200 to either side.
std::vector<LatticePoint> zigzag(std::int32_t count) {
  std::vector<LatticePoint> points;
  for (std::int32_t i = 0; i < count; ++i) points.push_back({1000 * i, i % 2 == 0 ? 200 : -200});
  return points;
}

std::int32_t widest(const StrokeModel& drawing, std::int32_t x_from, std::int32_t x_to) {
  std::int32_t most = 0;
  for (const Stroke& s : drawing.strokes) {
    for (const LatticePoint p : {s.from, s.to})
      if (p.x > x_from && p.x < x_to) most = std::max(most, std::abs(p.y));
  }
  return most;
}

TEST(SmoothLines, DoNotZigzag) {
  StrokeModel drawing = model(strokes_along(zigzag(21)));
  EXPECT_EQ(smooth(drawing), 19u);
  EXPECT_LT(widest(drawing, 4500, 15500), 20);
  EXPECT_LT(widest(drawing, 500, 19500), 120) << "beside the ends";
}

TEST(SmoothLines, StayConnectedAndKeepTheirEnds) {
  const std::vector<LatticePoint> points = zigzag(12);
  StrokeModel drawing = model(strokes_along(points));
  smooth(drawing);
  EXPECT_EQ(drawing.strokes.front().from, points.front());
  const Stroke& last = drawing.strokes.back();
  EXPECT_EQ(last.to, points.back());
  for (std::size_t i = 0; i + 1 < drawing.strokes.size(); ++i) {
    const Stroke &a = drawing.strokes[i], &b = drawing.strokes[i + 1];
    EXPECT_EQ(i % 2 == 0 ? a.to : a.from, i % 2 == 0 ? b.to : b.from) << i;
  }
}

TEST(SmoothLines, OfOtherThingsStay) {
  const std::vector<Stroke> strokes = strokes_along(zigzag(12), kOther);
  StrokeModel drawing = model(strokes);
  EXPECT_EQ(smooth(drawing), 0u);
  EXPECT_EQ(drawing.strokes[5].from, strokes[5].from);
}

TEST(SmoothLines, StayWhereOthersMeetThemAndWhereTheyBecomeHidden) {
  const std::vector<LatticePoint> points = zigzag(21);
  std::vector<Stroke> met = strokes_along(points), ends_hidden = met;
  met.push_back(stroke(points[10], {10000, 9000}, LineClass::outline, kOther));
  for (std::size_t i = 10; i < ends_hidden.size(); ++i) ends_hidden[i] = hidden(ends_hidden[i]);
  StrokeModel drawing = model(met);
  EXPECT_EQ(smooth(drawing), 18u);
  EXPECT_EQ(drawing.strokes[9].from, points[10]);
  drawing = model(ends_hidden);
  EXPECT_EQ(smooth(drawing), 18u);
  EXPECT_EQ(drawing.strokes[10].from, points[10]);
}

TEST(SmoothLines, KeepCorners) {
  std::vector<LatticePoint> points;
  for (std::int32_t i = 0; i <= 10; ++i) points.push_back({1000 * i, 0});
  for (std::int32_t i = 1; i <= 10; ++i) points.push_back({10000, 1000 * i});
  StrokeModel drawing = model(strokes_along(points));
  smooth(drawing);
  EXPECT_EQ(drawing.strokes[9].from, points[10]);
  EXPECT_EQ(widest(drawing, 0, 9900), 0);
}

TEST(SmoothLines, KeepTheCornersOfARing) {
  std::vector<LatticePoint> points;  // a square that begins in the middle of a side
  for (std::int32_t i = 5; i < 10; ++i) points.push_back({1000 * i, 0});
  for (std::int32_t i = 0; i < 10; ++i) points.push_back({10000, 1000 * i});
  for (std::int32_t i = 10; i > 0; --i) points.push_back({1000 * i, 10000});
  for (std::int32_t i = 10; i > 0; --i) points.push_back({0, 1000 * i});
  for (std::int32_t i = 0; i < 5; ++i) points.push_back({1000 * i, 0});
  points[2].y = points.back().y = 300;
  points.push_back(points.front());
  StrokeModel drawing = model(strokes_along(points));
  smooth(drawing);
  for (const LatticePoint corner : {LatticePoint{10000, 0}, {10000, 10000}, {0, 10000}, {0, 0}})
    EXPECT_TRUE(std::ranges::any_of(drawing.strokes, [&](const Stroke& s) { return s.from == corner || s.to == corner; }));
  EXPECT_LT(std::abs(drawing.strokes[1].to.y), 150);
  EXPECT_LT(std::abs(drawing.strokes.back().from.y), 150) << "before the place where it begins";
}

TEST(SmoothLines, KeepTheRadiusOfARing) {
  constexpr std::size_t kPoints = 20;
  constexpr double kRadius = 10000;
  std::vector<LatticePoint> points;
  for (std::size_t i = 0; i <= kPoints; ++i) {
    const double a = 2 * std::numbers::pi * double(i % kPoints) / kPoints;
    points.push_back({std::int32_t(std::lround(kRadius * std::cos(a))), std::int32_t(std::lround(kRadius * std::sin(a)))});
  }
  StrokeModel drawing = model(strokes_along(points));
  smooth(drawing);
  for (const Stroke& s : drawing.strokes) {
    EXPECT_NEAR(std::hypot(s.from.x, s.from.y), kRadius, 0.01 * kRadius);
    EXPECT_NEAR(std::hypot(s.to.x, s.to.y), kRadius, 0.01 * kRadius);
  }
}

}  // namespace
}  // namespace ligne
