/// Outlines of what is rough on a scan.
#include "drawing/flecks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ligne {
namespace {

/// Strokes on the page with steps of 1/1000 mm; sources below 100 are of the rough body.
class Page {
 public:
  Page() {
    model.lattice.step_mm = 0.001;
    model.edge_count = 1000;
    add(0, {0, 0}, {200, 0});  // the body is large
  }

  Page& add(std::uint32_t source, Point2 from, Point2 to, LineClass line_class = LineClass::outline, bool visible = true) {
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
    return drop_flecks(model, [](const Stroke& s) { return s.source < 100 ? 0u : kNoBody; },
                       {.longest_mm = 2, .body_part = 1.0 / 48, .touching_mm = 0.1});
  }

  StrokeModel model;
};

TEST(Flecks, AreShortOutlinesOfRoughBodies) {
  Page page;
  page.add(1, {10, 10}, {11, 10}).add(1, {11, 10}, {11.5, 10.5});  // one chain
  page.add(2, {20, 10}, {22.5, 10});                               // too long
  page.add(3, {30, 10}, {31, 10}, LineClass::crease);
  page.add(100, {40, 10}, {41, 10});  // of a body that is not rough
  EXPECT_EQ(page.drop(), 1u);
  EXPECT_EQ(page.model.strokes.size(), 4u);
}

TEST(Flecks, AreSmallAgainstTheirBody) {
  Page page;
  page.model.strokes.clear();
  page.add(0, {0, 0}, {20, 0}).add(1, {10, 10}, {11, 10});
  EXPECT_EQ(page.drop(), 0u);
}

TEST(Flecks, EndAtNoMoreThanOneLine) {
  Page spur;
  spur.add(1, {10, 0}, {11, 1});
  EXPECT_EQ(spur.drop(), 1u);
  Page bridge;
  bridge.add(1, {10, 0}, {10, 1.5}).add(2, {5, 1.5}, {15, 1.5});
  EXPECT_EQ(bridge.drop(), 0u);
}

TEST(Flecks, HideNoLine) {
  Page page;
  page.add(1, {10, 10}, {11, 10}).add(2, {10.5, 10}, {10.5, 40});
  EXPECT_EQ(page.drop(), 0u) << "the second line goes on behind the first";
}

TEST(Flecks, ThatTouchCountTogether) {
  Page page;
  page.add(1, {10, 10}, {11, 10}).add(2, {10.5, 10.05}, {10.5, 10.6});
  EXPECT_EQ(page.drop(), 2u);
  Page outline;  // of pieces that end on each other
  for (int i = 0; i < 8; ++i) outline.add(1, {10.0 + i, 10 + 0.05 * (i % 2)}, {11.05 + i, 10 + 0.05 * (i % 2)});
  EXPECT_EQ(outline.drop(), 0u);
}

TEST(Flecks, AreOpen) {
  Page page;
  page.add(1, {10, 10}, {11, 10}).add(1, {11, 10}, {10, 10.5}).add(1, {10, 10.5}, {10, 10});
  EXPECT_EQ(page.drop(), 0u) << "a small body before the large one";
}

TEST(Flecks, BecomeHiddenWhereHiddenLinesAreDrawn) {
  Page page;
  page.add(1, {10, 10}, {11, 10}).add(1, {11, 10}, {14, 10}, LineClass::outline, false);
  EXPECT_EQ(page.drop(), 1u);
  EXPECT_EQ(page.model.strokes.size(), 3u);
  EXPECT_FALSE(page.model.strokes[1].visible);
}

}  // namespace
}  // namespace ligne
