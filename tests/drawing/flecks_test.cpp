/// Outlines of what is rough on a scan.
#include "drawing/flecks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawing/spurs.hpp"
#include "scan_page.hpp"

namespace ligne {
namespace {

std::size_t drop_flecks_of(ScanPage& page) {
  return drop_flecks(page.model, ScanPage::body_of, {.longest_mm = 2, .body_part = 1.0 / 48, .touching_mm = 0.1});
}

TEST(Flecks, AreShortOutlinesOfRoughBodies) {
  ScanPage page;
  page.add(1, {10, 10}, {11, 10}).add(1, {11, 10}, {11.5, 10.5});  // one chain
  page.add(2, {20, 10}, {22.5, 10});                               // too long
  page.add(3, {30, 10}, {31, 10}, LineClass::crease);
  page.add(100, {40, 10}, {41, 10});  // of a body that is not rough
  EXPECT_EQ(drop_flecks_of(page), 1u);
  EXPECT_EQ(page.model.strokes.size(), 4u);
}

TEST(Flecks, AreSmallAgainstTheirBody) {
  ScanPage page;
  page.model.strokes.clear();
  page.add(0, {0, 0}, {20, 0}).add(1, {10, 10}, {11, 10});
  EXPECT_EQ(drop_flecks_of(page), 0u);
}

TEST(Flecks, EndAtNoMoreThanOneLine) {
  ScanPage spur;
  spur.add(1, {10, 0}, {11, 1});
  EXPECT_EQ(drop_flecks_of(spur), 1u);
  ScanPage bridge;
  bridge.add(1, {10, 0}, {10, 1.5}).add(2, {5, 1.5}, {15, 1.5});
  EXPECT_EQ(drop_flecks_of(bridge), 0u);
}

TEST(Flecks, HideNoLine) {
  ScanPage page;
  page.add(1, {10, 10}, {11, 10}).add(2, {10.5, 10}, {10.5, 40});
  EXPECT_EQ(drop_flecks_of(page), 0u) << "the second line goes on behind the first";
}

TEST(Flecks, ThatTouchCountTogether) {
  ScanPage page;
  page.add(1, {10, 10}, {11, 10}).add(2, {10.5, 10.05}, {10.5, 10.6});
  EXPECT_EQ(drop_flecks_of(page), 2u);
  ScanPage outline;  // of pieces that end on each other
  for (int i = 0; i < 8; ++i) outline.add(1, {10.0 + i, 10 + 0.05 * (i % 2)}, {11.05 + i, 10 + 0.05 * (i % 2)});
  EXPECT_EQ(drop_flecks_of(outline), 0u);
}

TEST(Flecks, OfAnyClassMeetNoLine) {
  const auto drop_lone = [](ScanPage& page) {
    return drop_flecks(page.model, ScanPage::body_of,
                       {.longest_mm = 2,
                        .body_part = 1.0 / 48,
                        .touching_mm = 0.1,
                        .classes = LineClasses::features(),
                        .most_ends_on_lines = 0,
                        .ring_width_mm = 0.1});
  };
  ScanPage lone;
  lone.add(1, {10, 10}, {11, 10}, LineClass::crease);
  lone.add(2, {20, 10}, {21.5, 10}).add(3, {21.5, 10.05}, {20, 10.2}, LineClass::intersection);  // 3 mm in a box of 1.5
  lone.add(4, {30, 10}, {31, 10}, LineClass::mesh);
  EXPECT_EQ(drop_lone(lone), 3u);
  ASSERT_EQ(lone.model.strokes.size(), 2u);
  EXPECT_EQ(lone.model.strokes[1].line_class, LineClass::mesh);
  ScanPage met;
  met.add(1, {10, 0}, {11, 1}, LineClass::crease).add(2, {20, 0.05}, {21, 1});
  EXPECT_EQ(drop_lone(met), 0u) << "each has an end on a line";
  const auto ring = [](double y, double width) {
    ScanPage page;
    page.add(1, {10, y}, {11.5, y}).add(1, {11.5, y}, {10.7, y + width}).add(1, {10.7, y + width}, {10, y});
    return page;
  };
  ScanPage narrow = ring(10, 0.08), wide = ring(10, 0.12), beside = ring(0.05, 0.08);
  EXPECT_EQ(drop_lone(narrow), 1u);
  EXPECT_EQ(drop_lone(wide), 0u) << "a small hole";
  EXPECT_EQ(drop_lone(beside), 0u) << "it lies on a line";
}

TEST(Flecks, AreOpen) {
  ScanPage page;
  page.add(1, {10, 10}, {11, 10}).add(1, {11, 10}, {10, 10.5}).add(1, {10, 10.5}, {10, 10});
  EXPECT_EQ(drop_flecks_of(page), 0u) << "a small body before the large one";
}

TEST(Flecks, BecomeHiddenWhereHiddenLinesAreDrawn) {
  ScanPage page;
  page.add(1, {10, 10}, {11, 10}).add(1, {11, 10}, {14, 10}, LineClass::outline, false);
  EXPECT_EQ(drop_flecks_of(page), 1u);
  EXPECT_EQ(page.model.strokes.size(), 3u);
  EXPECT_FALSE(page.model.strokes[1].visible);
}

TEST(Flecks, AreNoneInALineOfFoldsWithoutSpurs) {
  // An outline of four folds, each of which begins beside the one before: with its spurs left out, its second piece has no
  // end nearer than 0.26 mm to the others.
  ScanPage page;
  page.add(1, {158.5, 10}, {158.525, 27.993}).add(1, {158.525, 27.993}, {158.583, 29.915});
  page.add(1, {158.583, 29.915}, {158.365, 30.659});
  page.add(2, {158.321, 29.886}, {158.427, 31.758}).add(2, {158.427, 31.758}, {158.058, 32.159});
  page.add(3, {158.377, 31.771}, {158.084, 33.202});
  page.add(4, {158.048, 31.771}, {158.095, 33.606}).add(4, {158.095, 33.606}, {157.643, 34.318});
  page.add(4, {157.643, 34.318}, {150, 45});
  EXPECT_GT(drop_spurs(page.model, ScanPage::body_of,
                       {.longest_mm = 4.2,
                        .body_part = 1.0 / 32,
                        .beside_mm = 0.875,
                        .beside_times = 4,
                        .touching_mm = 0.35,
                        .gap_mm = 1.4}),
            0u);
  drop_flecks(page.model, ScanPage::body_of, {.longest_mm = 2.8, .body_part = 1.0 / 48, .touching_mm = 0.35});
  EXPECT_TRUE(std::ranges::any_of(page.model.strokes,
                                  [&](const Stroke& s) { return s.source == 2 && page.model.lattice.to_mm(s.to).y > 31; }));
}

}  // namespace
}  // namespace ligne
