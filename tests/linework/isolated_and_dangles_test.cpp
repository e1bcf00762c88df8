/// Outlines of scans that are left out: short ones by themselves, and those that leave an outline and lead nowhere.
#include "base/no_index.hpp"
#include "rule_runner.hpp"
#include "stroke_builder.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

std::uint32_t body_of(const Stroke& s) { return s.source < 100 ? 0u : kNone; }

/// Strokes in words beside a body whose outline is 200 mm long.
StrokeModel beside_a_body(const std::string& text) { return scan("0,0 200,0; " + text); }

std::size_t prune(StrokeModel& m, const DangleLimits& limits) {
  return apply_rule(m, limits.touching_mm, [&](LineMap& map) { return prune_dangles(map, body_of, limits); });
}
std::size_t remove_isolated(StrokeModel& m, const IsolatedLimits& limits, double touching_mm) {
  return apply_rule(m, touching_mm, [&](LineMap& map) { return remove_isolated_chains(map, body_of, limits); });
}
std::size_t remove_flecks(StrokeModel& m) { return remove_isolated(m, {.longest_mm = 2, .body_part = 1.0 / 48}, 0.1); }

TEST(IsolatedChains, AreShortAndOpen) {
  StrokeModel m = beside_a_body(
      "#1 10,10 11,10 11.5,10.5; #2 20,10 22.5,10; crease#3 30,10 31,10; #100 40,10 41,10; mesh#4 50,10 51,10");
  EXPECT_EQ(remove_flecks(m), 2u) << "the second is too long, the fourth of no body, the last no feature";
  EXPECT_EQ(m.strokes.size(), 4u);
  expect_changes({{"large against its body", "0,0 20,0; #1 10,10 11,10", 0},
                  {"touching, they count together", "0,0 200,0; #1 10,10 11,10; #2 10.5,10.05 10.5,10.6", 1},
                  {"together too large", "0,0 200,0; #1 10,10 11.5,10; #2 11.5,10.05 11.5,11.5", 0},
                  {"a small body before the large one", "0,0 200,0; #1 10,10 11,10 10,10.5 10,10", 0}},
                 remove_flecks, scan);
  std::string pieces;  // of an outline; they end on each other
  for (int i = 0; i < 8; ++i) {
    const std::string y = i % 2 == 0 ? ",10 " : ",10.05 ";
    pieces += "#1 " + std::to_string(10 + i) + y + std::to_string(11.05 + i) + y + ";";
  }
  StrokeModel outline = beside_a_body(pieces);
  EXPECT_EQ(remove_flecks(outline), 0u);
}

TEST(IsolatedChains, MeetNoLine) {
  expect_changes({{"a spur", "#1 10,0 11,1", 0},
                  {"almost", "#1 10,0.05 11,1", 0},
                  {"it ends before the line", "#1 10,0.2 11,1", 1},
                  {"a bridge", "#1 10,0 10,1.5; #2 5,1.5 15,1.5", 0},
                  {"the second line goes on behind the first", "#1 10,10 11,10; #2 10.5,10 10.5,40", 0}},
                 remove_flecks, beside_a_body);
}

TEST(IsolatedChains, MayBeNarrowRings) {
  const auto remove_lone = [](StrokeModel& m) {
    return remove_isolated(m, {.longest_mm = 2, .body_part = 1.0 / 48, .ring_width_mm = 0.1}, 0.1);
  };
  expect_changes({{"a line there and back", "#1 10,10 11.5,10 10.7,10.08 10,10", 1},
                  {"beginning in its middle", "#1 10.7,10.08 10,10 11.5,10 10.7,10.08", 1},
                  {"a small hole", "#1 10,10 11.5,10 10.7,10.12 10,10", 0},
                  {"too long", "#1 10,10 13.5,10 10.7,10.08 10,10", 0}},
                 remove_lone, beside_a_body);
}

TEST(IsolatedChains, BecomeHiddenWhereHiddenLinesAreDrawn) {
  StrokeModel m = beside_a_body("#1 10,10 11,10; hidden #1 11,10 14,10");
  EXPECT_EQ(remove_flecks(m), 1u);
  EXPECT_EQ(m.strokes.size(), 3u);
  EXPECT_FALSE(m.strokes[1].visible);
}

TEST(IsolatedChains, AreNoneInALineOfFoldsWithoutSpurs) {
  // An outline of four folds, each of which begins beside the one before: with its spurs left out, its second piece has no
  // end nearer than 0.26 mm to the others.
  StrokeModel m = beside_a_body(
      "#1 158.5,10 158.525,27.993 158.583,29.915 158.365,30.659; #2 158.321,29.886 158.427,31.758 158.058,32.159;"
      "#3 158.377,31.771 158.084,33.202; #4 158.048,31.771 158.095,33.606 157.643,34.318 150,45");
  EXPECT_GT(prune(m, {.longest_mm = 4.2, .body_part = 1.0 / 32, .beside_mm = 0.875, .beside_times = 4, .touching_mm = 0.35}),
            0u);
  remove_isolated(m, {.longest_mm = 2.8, .body_part = 1.0 / 48}, 0.35);
  EXPECT_TRUE(
      std::ranges::any_of(m.strokes, [&](const Stroke& s) { return s.source == 2 && m.lattice.to_mm(s.to).y > 31; }));
}

std::size_t prune_all(StrokeModel& m) {
  return prune(m, {.longest_mm = 4, .body_part = 1.0 / 32, .beside_mm = 1, .beside_times = 4, .touching_mm = 0.2});
}

TEST(Dangles, LeaveALineAndEndFreely) {
  // From the side of a line; too long; meets nothing; of another body; no outline.
  StrokeModel m =
      beside_a_body("#1 50,0.1 51,3; #2 100,0.1 101,5; #3 120,2 121,4; #100 150,0.1 151,3; crease#4 170,0.1 171,3");
  EXPECT_EQ(prune_all(m), 1u);
  EXPECT_EQ(m.strokes.size(), 5u);
}

TEST(Dangles, EndTheLineThatTheyContinue) {
  // Shallow folds: each line bends off into the body where the next one begins on it.
  StrokeModel m = scan("#1 0,0 40.1,0 42,2; #1 40,0 80.1,0 82,2; #1 80,0 120.1,0 122,2");
  EXPECT_EQ(prune_all(m), 2u) << "the last one is the end of the line";
  double length = 0;
  for (const Stroke& s : m.strokes) length += glm::length(m.lattice.to_mm(s.to) - m.lattice.to_mm(s.from));
  EXPECT_NEAR(length, 123, 0.5);
}

TEST(Dangles, OfAForkTheLongerArmStays) {
  StrokeModel m = scan("#0 0,0 150,0; #1 150,0 152,1; #2 150,0 153,-1");
  EXPECT_EQ(prune_all(m), 1u);
  EXPECT_EQ(m.strokes.back().source, 2u);
}

TEST(Dangles, RunBesideALineAndKeepLinesConnected) {
  expect_changes({{"ends freely on both sides; on one; leaves the line and comes back; is too long",
                   "0,0 200,0; #1 50,0.8 60,0.6; #2 80,0.1 90,0.9; #3 110,0.1 115,0.8 120,0.1; #4 130,0.1 150,0.9", 3},
                  {"from line to line", "0,0 200,0; #1 50,0 50.5,3; #2 40,3 60,3", 0}},
                 prune_all, scan);
}

TEST(Dangles, AreHiddenWhereHiddenLinesAreDrawn) {
  StrokeModel m = beside_a_body("#1 50,0.1 51,3; hidden #100 10,10 20,20");
  EXPECT_EQ(prune_all(m), 1u);
  ASSERT_EQ(m.strokes.size(), 3u);
  EXPECT_FALSE(m.strokes[1].visible);
}

}  // namespace
}  // namespace ligne
