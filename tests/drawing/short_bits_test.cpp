/// Gaps that are closed, and bits of lines that are left out.
#include "drawing/short_bits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ligne {
namespace {

/// Strokes on the page with steps of 1/1000 mm.
class Strokes {
 public:
  StrokeModel model;

  Strokes() {
    model.lattice.step_mm = 0.001;
    model.edge_count = 1000;
  }

  /// From (x0, y) to (x1, y), mm, of a source that runs from x = 0 to x = 100.
  Strokes& add(std::uint32_t source, double x0, double x1, double y, bool visible = true) {
    Stroke s;
    s.t_from = x0 / 100;
    s.t_to = x1 / 100;
    s.from = {static_cast<std::int32_t>(std::lround(x0 * 1000)), static_cast<std::int32_t>(std::lround(y * 1000))};
    s.to = {static_cast<std::int32_t>(std::lround(x1 * 1000)), s.from.y};
    s.source = source;
    s.line_class = LineClass::crease;
    s.visible = visible;
    model.strokes.push_back(s);
    return *this;
  }

  double visible_mm() const {
    double sum = 0;
    for (const Stroke& s : model.strokes) sum += s.visible ? (s.to.x - s.from.x) / 1000.0 : 0;
    return sum;
  }
};

TEST(ShortGaps, AreFilledIn) {
  Strokes s;
  s.add(1, 0, 40, 0).add(1, 40.2, 70, 0).add(1, 71, 100, 0);
  EXPECT_EQ(close_short_gaps(s.model, 0.5), 1u);
  EXPECT_NEAR(s.visible_mm(), 99, 1e-9);
}

TEST(ShortGaps, OfHiddenStrokesBecomeVisible) {
  Strokes s;
  s.add(1, 0, 40, 0).add(1, 40, 40.2, 0, false).add(1, 40.2, 100, 0).add(2, 0, 100, 5, false);
  EXPECT_EQ(close_short_gaps(s.model, 0.5), 1u);
  EXPECT_NEAR(s.visible_mm(), 100, 1e-9);
  EXPECT_EQ(s.model.strokes.size(), 4u);
}

TEST(ShortGaps, BetweenSourcesStay) {
  Strokes s;
  s.add(1, 0, 40, 0).add(2, 40.2, 70, 0);
  EXPECT_EQ(close_short_gaps(s.model, 0.5), 0u);
}

TEST(ShortBits, ThatVisibilityCutsOffGo) {
  Strokes s;
  s.add(1, 10, 10.3, 0).add(2, 10, 10.8, 5).add(3, 0, 100, 9);
  EXPECT_EQ(drop_short_bits(s.model, 0.5), 1u);
  EXPECT_NEAR(s.visible_mm(), 100.8, 1e-9);
  EXPECT_EQ(s.model.strokes.size(), 2u);
}

TEST(ShortBits, BecomeHiddenWhereHiddenLinesAreDrawn) {
  Strokes s;
  s.add(1, 0, 10, 0, false).add(1, 10, 10.3, 0).add(1, 10.3, 100, 0, false);
  EXPECT_EQ(drop_short_bits(s.model, 0.5), 1u);
  EXPECT_EQ(s.visible_mm(), 0);
  EXPECT_EQ(s.model.strokes.size(), 3u);
}

TEST(ShortBits, OfOneChainCountTogether) {
  Strokes s;
  s.add(1, 10, 10.3, 0).add(2, 10.3, 10.6, 0);
  EXPECT_EQ(drop_short_bits(s.model, 0.5), 0u);
  EXPECT_EQ(drop_short_bits(s.model, 0.7), 1u);
}

TEST(ShortBits, IntersectionsByThemselvesGoEvenWhole) {
  Strokes s;
  s.add(1, 0, 0.3, 0).add(2, 0, 100, 5);
  s.model.strokes[0].t_to = 1;
  EXPECT_EQ(drop_short_bits(s.model, 0.5), 0u);
  s.model.strokes[0].line_class = LineClass::intersection;
  EXPECT_EQ(drop_short_bits(s.model, 0.5), 1u);
}

TEST(ShortBits, WholeFeaturesAndWhatJoinsLinesStay) {
  Strokes whole;
  whole.add(1, 0, 100, 0);
  EXPECT_EQ(drop_short_bits(whole.model, 200), 0u) << "an edge that is seen from end to end";
  Strokes joined;
  joined.add(1, 10, 10.3, 0).add(2, 10.3, 60, 0);
  joined.model.strokes[1].to.y = 20'000;
  joined.add(3, 10.3, 50, 0);
  EXPECT_EQ(drop_short_bits(joined.model, 0.5), 0u) << "it ends where two others do";
}

}  // namespace
}  // namespace ligne
