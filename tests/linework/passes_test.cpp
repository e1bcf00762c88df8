/// Passes of the cleaning of lines: nodes, runs that are drawn over, smooth lines.

#include "base/no_index.hpp"
#include "linework/map/continuations.hpp"
#include "linework/map/line_groups.hpp"
#include "linework/near_part.hpp"
#include "linework/rules/smooth_lines.hpp"
#include "rule_runner.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using Ends = std::vector<std::uint32_t>;

// The places where strokes end, against a map of all of them.

/// Random strokes between places of a square, so many to a side.
std::vector<Stroke> random_strokes(std::size_t count, std::uint32_t side) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<std::int32_t>(random() % side); };
  std::vector<Stroke> strokes(count);
  for (Stroke& s : strokes) s.from = {coordinate(), coordinate()}, s.to = {coordinate(), coordinate()};
  return strokes;
}

/// By place, every third stroke left out.
void expect_all_places(std::size_t count, std::uint32_t side) {
  const std::vector<Stroke> strokes = random_strokes(count, side);
  std::vector<std::uint32_t> members;
  for (std::uint32_t i = 0; i < count; ++i)
    if (i % 3 != 0) members.push_back(i);
  std::map<LatticePoint, Ends> expected;
  for (std::uint32_t i = 0; i < members.size(); ++i) {
    expected[strokes[members[i]].from].push_back(2 * i);
    expected[strokes[members[i]].to].push_back(2 * i + 1);
  }
  // Places are visited at once, so each writes what is its own.
  std::vector<Ends> found(2 * members.size());
  for_each_node(strokes, members, [&](std::span<const StrokeEnd> ends) {
    Ends& here = found[ends[0].end];
    for (const auto& [p, end] : ends) {
      EXPECT_EQ(p, ends[0].p);
      here.push_back(end);
    }
  });
  std::size_t places = 0;
  for (const Ends& here : found) {
    if (here.empty()) continue;
    ++places;
    const Stroke& s = strokes[members[here[0] / 2]];
    EXPECT_EQ(here, expected[here[0] % 2 == 0 ? s.from : s.to]);
  }
  EXPECT_EQ(places, expected.size());
}

TEST(StrokeNodes, AllEndsAreVisitedPlaceByPlace) {
  expect_all_places(0, 1);
  expect_all_places(20, 3);
  expect_all_places(30'000, 100);
  expect_all_places(300'000, 400);
}

std::vector<std::uint32_t> paired(const std::vector<LatticePoint>& directions,
                                  void (*pair)(std::span<const NodeArm>, std::span<std::uint32_t>) = pair_arms) {
  std::vector<NodeArm> arms;
  for (const LatticePoint d : directions) arms.push_back({d, static_cast<std::uint32_t>(arms.size())});
  std::vector<std::uint32_t> partner(arms.size(), kNone);
  pair(arms, partner);
  return partner;
}

using ArmPartners = std::vector<std::uint32_t>;
constexpr std::uint32_t none = kNone;

/// The lines that partners make, as the first ends of their strokes; a ring ends with kNone.
std::vector<Ends> lines_of(const Ends& partner, LineOrder order) {
  std::vector<Ends> lines;
  for_each_line(partner, order, [&](std::span<const std::uint32_t> ends, bool is_ring) {
    lines.emplace_back(ends.begin(), ends.end());
    if (is_ring) lines.back().push_back(kNone);
  });
  return lines;
}

TEST(Continuations, LinesBeginAtLooseEndsOrWithTheirLowestStrokes) {
  // Strokes 0 and 3 are a ring, strokes 4, 1 and 2 an open line: end 9 is loose, 8 continues 2, 3 continues 5, 4 is loose.
  Ends partner(10, kNone);
  const auto pair = [&](std::uint32_t a, std::uint32_t b) { partner[a] = b, partner[b] = a; };
  pair(1, 6), pair(7, 0), pair(8, 2), pair(3, 5);
  EXPECT_EQ(lines_of(partner, LineOrder::loose_ends), (std::vector<Ends>{{4, 3, 8}, {0, 6, kNone}}));
  EXPECT_EQ(lines_of(partner, LineOrder::strokes), (std::vector<Ends>{{0, 6, kNone}, {9, 2, 5}}));
  EXPECT_TRUE(lines_of({}, LineOrder::strokes).empty());
}

TEST(NodePairs, KnownAnswers) {
  EXPECT_EQ(paired({{1, 0}}), (ArmPartners{none}));
  EXPECT_EQ(paired({{1, 0}, {1, 1}}), (ArmPartners{1, 0})) << "two arms are paired at any angle";
  EXPECT_EQ(paired({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}), (ArmPartners{2, 3, 0, 1}));
  EXPECT_EQ(paired({{1, 0}, {1, 1}, {1, -1}}), (ArmPartners{none, 2, 1})) << "a turn of exactly 90 degrees is allowed";
  EXPECT_EQ(paired({{2, 0}, {2, 1}, {2, -1}}), (ArmPartners{none, none, none})) << "all turns are sharper than 90 degrees";
  EXPECT_EQ(paired({{9, 0}, {-9, 1}, {-9, 0}}), (ArmPartners{2, none, 0})) << "the straighter of two";
  EXPECT_EQ(paired({{1, 0}, {-1, 0}, {1, 0}, {-1, 0}}), (ArmPartners{1, 0, 3, 2})) << "equal turns go by number";
}

TEST(NodePairs, TurnsAreToldApartToTheLastStep) {
  constexpr std::int32_t far = 1 << 26;
  EXPECT_EQ(paired({{far, 0}, {-far, 1}, {-far + 1, 1}}), (ArmPartners{1, 0, none}));
  EXPECT_EQ(paired({{far, 0}, {-far + 1, 1}, {-far, 1}}), (ArmPartners{2, none, 0}));
}

TEST(NodePairs, FewAndManyArmsAgree) {
  std::mt19937 random(11);
  for (int round = 0; round < 5000; ++round) {
    std::vector<LatticePoint> directions(3 + random() % (kFewArms - 2));
    const int spread = round % 3 == 0 ? 1 << 20 : 1 << 26;
    for (LatticePoint& d : directions) {
      d = {int(random() % spread) - (round % 2 ? spread / 2 : 0), int(random() % (1 << 26)) - (1 << 25)};
      if (d == LatticePoint{}) d.x = 1;
    }
    EXPECT_EQ(paired(directions, pair_few_arms), paired(directions, pair_many_arms)) << "round " << round;
  }
}

TEST(NodePairs, ManyArmsOnTwoFansStayFast) {
  // Every arm of the left fan wants the same arm of the right one: a search per arm would take the square of their number.
  std::vector<LatticePoint> directions;
  for (int i = 0; i < 50000; ++i) {
    directions.push_back({-(1 << 25), i * 100});
    directions.push_back({1 << 25, i * 100 + 7});
  }
  const ArmPartners partner = paired(directions);
  for (std::uint32_t i = 0; i < partner.size(); ++i) ASSERT_EQ(partner[partner[i]], i);
}

// Runs that do not show beside the ink of other lines, against a plain search for them.

constexpr auto kCrease = LineClass::crease, kOutline = LineClass::outline;

std::size_t remove_overdrawn(StrokeModel& m, const OverdrawLimits& limits) {
  return apply_rule(m, 0, [&](LineMap& map) { return remove_overdrawn_runs(map, limits); });
}

TEST(AddedRuns, AreNotOverdrawn) {
  for (const bool is_added : {false, true}) {
    StrokeModel m = sketch("0,0 600,0; crease 300,0 300,20", kOutline);
    m.strokes.back().is_joint = is_added;  // the rule that added it would add it again
    EXPECT_EQ(remove_overdrawn(m, {50, 17, 17}), is_added ? 0u : 1u);
  }
}

/// A plain search for the same: every bit against every line.
std::vector<Stroke> left_by_all_pairs(StrokeModel m, const OverdrawLimits& limits) {
  const LineMap map(m, is_no_mesh, {}, 100);  // a piece has the number of its stroke
  const Runs runs(map);
  const auto is_short = [&](std::uint32_t i) { return runs[runs.of(i)].length < limits.longest_mm; };
  std::vector<double> shown(m.strokes.size(), 0);
  std::vector<bool> touches(m.strokes.size(), false);
  for (std::uint32_t i = 0; i < m.strokes.size(); ++i) {
    if (!is_short(i)) continue;
    constexpr int kPlaces = 4096;  // along the bit
    std::vector<bool> inked(kPlaces, false);
    for (std::uint32_t k = 0; k < m.strokes.size(); ++k) {
      if (is_short(k)) continue;
      const StrokePart part = part_near(m.strokes[i], m.strokes[k], limits.ink_mm);
      for (int place = 0; place < kPlaces; ++place) {
        const double at = (place + 0.5) / kPlaces;
        if (part.from <= at && at <= part.to) inked[place] = true;
      }
      if (!part.empty()) touches[runs.of(i)] = true;
    }
    shown[runs.of(i)] += page_length(m.strokes[i]) * double(std::count(inked.begin(), inked.end(), false)) / kPlaces;
  }
  std::vector<Stroke> left;
  for (std::uint32_t i = 0; i < m.strokes.size(); ++i) {
    const std::uint32_t run = runs.of(i);
    if (!is_short(i) || !touches[run] || shown[run] >= limits.shown_mm) left.push_back(m.strokes[i]);
  }
  return left;
}

TEST(OverdrawnRunsRandom, AreThoseOfAllPairs) {
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
      const OverdrawLimits limits{50, ink, 17};
      const std::vector<Stroke> left = left_by_all_pairs(m, limits);
      remove_overdrawn(m, limits);
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
