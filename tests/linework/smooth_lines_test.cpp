/// Lines along the edges of scans, drawn as one smooth line.
#include "linework/rules/smooth_lines.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

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
