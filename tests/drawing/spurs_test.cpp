/// Outlines of scans that leave an outline and lead nowhere.
#include "drawing/spurs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

namespace ligne {
namespace {

/// Strokes on the page with steps of 1/1000 mm; sources below 100 are of the rough body, whose outline is 200 mm long.
class Scan {
 public:
  Scan() {
    model.lattice.step_mm = 0.001;
    model.edge_count = 1000;
    add(0, {0, 0}, {200, 0});
  }

  Scan& add(std::uint32_t source, Point2 from, Point2 to, LineClass line_class = LineClass::outline, bool visible = true) {
    Stroke s;
    s.from = model.lattice.snap(from);
    s.to = model.lattice.snap(to);
    s.source = source;
    s.line_class = line_class;
    s.visible = visible;
    model.strokes.push_back(s);
    return *this;
  }
  std::size_t drop() {
    return drop_spurs(
        model, [](const Stroke& s) { return s.source < 100 ? 0u : kNoBody; },
        {.longest_mm = 4, .body_part = 1.0 / 32, .beside_mm = 1, .beside_times = 4, .touching_mm = 0.2, .gap_mm = 1.5});
  }

  StrokeModel model;
};

TEST(Spurs, LeaveALineAndEndFreely) {
  Scan scan;
  scan.add(1, {50, 0.1}, {51, 3});      // from the side of a line
  scan.add(2, {100, 0.1}, {101, 5});    // too long
  scan.add(3, {120, 2}, {121, 4});      // meets nothing
  scan.add(100, {150, 0.1}, {151, 3});  // of another body
  scan.add(4, {170, 0.1}, {171, 3}, LineClass::crease);
  EXPECT_EQ(scan.drop(), 1u);
  EXPECT_EQ(scan.model.strokes.size(), 5u);
}

TEST(Spurs, AreNoneWhereTheLineGoesOnBehindAGap) {
  Scan scan;
  scan.model.strokes.clear();
  // An outline bends off at a fork, and goes on after a gap; a tooth of the same size beside it is a spur.
  scan.add(0, {0, 0}, {100, 0}).add(1, {100, 0}, {103, -1}).add(2, {100, 0}, {102, 3}).add(3, {103, 3.5}, {150, 40});
  scan.add(4, {50, 0.1}, {52, 3}).add(5, {53, 0.1}, {53, 3});
  EXPECT_EQ(scan.drop(), 3u);
  std::vector<std::uint32_t> kept;
  for (const Stroke& s : scan.model.strokes) kept.push_back(s.source);
  EXPECT_EQ(std::ranges::count(kept, 2u), 1);
  EXPECT_EQ(std::ranges::count(kept, 4u) + std::ranges::count(kept, 5u), 0);
}

TEST(Spurs, EndTheLineThatTheyContinue) {
  Scan scan;
  scan.model.strokes.clear();
  // Shallow folds: each line bends off into the body where the next one begins on it.
  for (int i = 0; i < 3; ++i) {
    scan.add(1, {40.0 * i, 0}, {40.0 * i + 40, 0}).add(1, {40.0 * i + 40, 0}, {40.0 * i + 42, 2});
    scan.model.strokes[scan.model.strokes.size() - 2].to = scan.model.lattice.snap({40.0 * i + 40.1, 0});
    scan.model.strokes.back().from = scan.model.lattice.snap({40.0 * i + 40.1, 0});
  }
  EXPECT_EQ(scan.drop(), 2u) << "the last one is the end of the line";
  double length = 0;
  for (const Stroke& s : scan.model.strokes)
    length += glm::length(scan.model.lattice.to_mm(s.to) - scan.model.lattice.to_mm(s.from));
  EXPECT_NEAR(length, 123, 0.5);
}

TEST(Spurs, OfAForkTheLongerArmStays) {
  Scan scan;
  scan.model.strokes.clear();
  scan.add(0, {0, 0}, {150, 0}).add(1, {150, 0}, {152, 1}).add(2, {150, 0}, {153, -1});
  EXPECT_EQ(scan.drop(), 1u);
  EXPECT_EQ(scan.model.strokes.back().source, 2u);
}

TEST(Spurs, RunBesideALine) {
  Scan scan;
  scan.add(1, {50, 0.8}, {60, 0.6});                                   // ends freely on both sides
  scan.add(2, {80, 0.1}, {90, 0.9});                                   // on one
  scan.add(3, {110, 0.1}, {115, 0.8}).add(3, {115, 0.8}, {120, 0.1});  // leaves the line and comes back
  scan.add(4, {130, 0.1}, {150, 0.9});                                 // too long
  EXPECT_EQ(scan.drop(), 3u);
}

TEST(Spurs, KeepLinesConnected) {
  Scan scan;
  scan.add(1, {50, 0}, {50.5, 3}).add(2, {40, 3}, {60, 3});  // from line to line
  EXPECT_EQ(scan.drop(), 0u);
}

TEST(Spurs, AreHiddenWhereHiddenLinesAreDrawn) {
  Scan scan;
  scan.add(1, {50, 0.1}, {51, 3}).add(100, {10, 10}, {20, 20}, LineClass::outline, false);
  EXPECT_EQ(scan.drop(), 1u);
  ASSERT_EQ(scan.model.strokes.size(), 3u);
  EXPECT_FALSE(scan.model.strokes[1].visible);
}

}  // namespace
}  // namespace ligne
