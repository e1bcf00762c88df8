/// Outlines of scans that leave an outline and lead nowhere.
#include "drawing/spurs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "scan_page.hpp"

namespace ligne {
namespace {

std::size_t drop_spurs_of(ScanPage& scan) {
  return drop_spurs(
      scan.model, ScanPage::body_of,
      {.longest_mm = 4, .body_part = 1.0 / 32, .beside_mm = 1, .beside_times = 4, .touching_mm = 0.2, .gap_mm = 1.5});
}

TEST(Spurs, LeaveALineAndEndFreely) {
  ScanPage scan;
  scan.add(1, {50, 0.1}, {51, 3});      // from the side of a line
  scan.add(2, {100, 0.1}, {101, 5});    // too long
  scan.add(3, {120, 2}, {121, 4});      // meets nothing
  scan.add(100, {150, 0.1}, {151, 3});  // of another body
  scan.add(4, {170, 0.1}, {171, 3}, LineClass::crease);
  EXPECT_EQ(drop_spurs_of(scan), 1u);
  EXPECT_EQ(scan.model.strokes.size(), 5u);
}

TEST(Spurs, AreNoneWhereTheLineGoesOnBehindAGap) {
  ScanPage scan;
  scan.model.strokes.clear();
  // An outline bends off at a fork, and goes on after a gap; a tooth of the same size beside it is a spur.
  scan.add(0, {0, 0}, {100, 0}).add(1, {100, 0}, {103, -1}).add(2, {100, 0}, {102, 3}).add(3, {103, 3.5}, {150, 40});
  scan.add(4, {50, 0.1}, {52, 3}).add(5, {53, 0.1}, {53, 3});
  EXPECT_EQ(drop_spurs_of(scan), 3u);
  std::vector<std::uint32_t> kept;
  for (const Stroke& s : scan.model.strokes) kept.push_back(s.source);
  EXPECT_EQ(std::ranges::count(kept, 2u), 1);
  EXPECT_EQ(std::ranges::count(kept, 4u) + std::ranges::count(kept, 5u), 0);
}

TEST(Spurs, AreNoneWhereOneOfTheLinesBehindAGapIsTheirOwn) {
  ScanPage scan;
  scan.model.strokes.clear();
  // What goes on after the gap has no other way to the fork, though a crease that ends beside it has.
  scan.add(0, {0, 0}, {100, 0}).add(2, {100, 0}, {102, 3}).add(3, {103, 3.5}, {150, 40});
  scan.add(1, {100, 0}, {101.5, 1.8}, LineClass::crease);
  EXPECT_EQ(drop_spurs_of(scan), 0u);
}

TEST(Spurs, EndTheLineThatTheyContinue) {
  ScanPage scan;
  scan.model.strokes.clear();
  // Shallow folds: each line bends off into the body where the next one begins on it.
  for (int i = 0; i < 3; ++i) {
    scan.add(1, {40.0 * i, 0}, {40.0 * i + 40, 0}).add(1, {40.0 * i + 40, 0}, {40.0 * i + 42, 2});
    scan.model.strokes[scan.model.strokes.size() - 2].to = scan.model.lattice.snap({40.0 * i + 40.1, 0});
    scan.model.strokes.back().from = scan.model.lattice.snap({40.0 * i + 40.1, 0});
  }
  EXPECT_EQ(drop_spurs_of(scan), 2u) << "the last one is the end of the line";
  double length = 0;
  for (const Stroke& s : scan.model.strokes)
    length += glm::length(scan.model.lattice.to_mm(s.to) - scan.model.lattice.to_mm(s.from));
  EXPECT_NEAR(length, 123, 0.5);
}

TEST(Spurs, OfAForkTheLongerArmStays) {
  ScanPage scan;
  scan.model.strokes.clear();
  scan.add(0, {0, 0}, {150, 0}).add(1, {150, 0}, {152, 1}).add(2, {150, 0}, {153, -1});
  EXPECT_EQ(drop_spurs_of(scan), 1u);
  EXPECT_EQ(scan.model.strokes.back().source, 2u);
}

TEST(Spurs, RunBesideALine) {
  ScanPage scan;
  scan.add(1, {50, 0.8}, {60, 0.6});                                   // ends freely on both sides
  scan.add(2, {80, 0.1}, {90, 0.9});                                   // on one
  scan.add(3, {110, 0.1}, {115, 0.8}).add(3, {115, 0.8}, {120, 0.1});  // leaves the line and comes back
  scan.add(4, {130, 0.1}, {150, 0.9});                                 // too long
  EXPECT_EQ(drop_spurs_of(scan), 3u);
}

TEST(Spurs, KeepLinesConnected) {
  ScanPage scan;
  scan.add(1, {50, 0}, {50.5, 3}).add(2, {40, 3}, {60, 3});  // from line to line
  EXPECT_EQ(drop_spurs_of(scan), 0u);
}

TEST(Spurs, AreHiddenWhereHiddenLinesAreDrawn) {
  ScanPage scan;
  scan.add(1, {50, 0.1}, {51, 3}).add(100, {10, 10}, {20, 20}, LineClass::outline, false);
  EXPECT_EQ(drop_spurs_of(scan), 1u);
  ASSERT_EQ(scan.model.strokes.size(), 3u);
  EXPECT_FALSE(scan.model.strokes[1].visible);
}

}  // namespace
}  // namespace ligne
