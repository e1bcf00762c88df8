// Spans as gray pixels and as hatching.

#include <gtest/gtest.h>

#include "drawing/shading.hpp"

namespace ligne {
namespace {

SpanModel model() {
  SpanModel m;
  m.lines = {0.5, 1, 16};
  for (std::uint32_t line = 0; line < 16; ++line) {
    m.spans.push_back({line, 2, 6, 0});
    m.spans.push_back({line, 6, 9.5, 1});
    m.spans.push_back({line, 12, 14, 2});
  }
  return m;
}

const std::vector<double> kBrightness{0.0, 0.6, 1.0};

TEST(Shading, PixelsAreMixedAtTheEndsOfSpans) {
  const GrayPicture p = shade(model(), kBrightness, 16, 16, 1);
  ASSERT_EQ(p.gray.size(), 256u);
  EXPECT_EQ(p.gray[0], 255);
  EXPECT_EQ(p.gray[2], 0);
  EXPECT_EQ(p.gray[5], 0);
  EXPECT_EQ(p.gray[6], 153);
  EXPECT_EQ(p.gray[9], 204);  // half of it
  EXPECT_EQ(p.gray[10], 255);
  EXPECT_EQ(p.gray[12], 255);
}

TEST(Shading, SpansBesideThePictureAreCut) {
  SpanModel m;
  m.lines = {0, 1, 9};
  m.spans = {{0, -5, 100, 0}, {7, 0, 1, 0}};
  const GrayPicture p = shade(m, kBrightness, 3, 2, 1);
  EXPECT_EQ(p.gray, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255}));
}

TEST(Shading, LevelsHatchEveryOtherLine) {
  for (unsigned levels = 1; levels <= kMostHatchLevels; ++levels) {
    const Polylines lines = hatch(model(), kBrightness, levels);
    std::size_t of_face[3] = {0, 0, 0};
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double from = std::min(lines[i][0].x, lines[i][1].x), to = std::max(lines[i][0].x, lines[i][1].x);
      EXPECT_EQ(lines[i][0].y, lines[i][1].y);
      of_face[0] += from <= 2 && to >= 6;
      of_face[1] += from <= 6 && to >= 9.5;
      of_face[2] += from <= 12 && to >= 14;
    }
    EXPECT_EQ(of_face[0], 16u);                        // the darkest on every line
    EXPECT_EQ(of_face[2], 16u >> (levels - 1));        // the brightest on the fewest
    EXPECT_EQ(of_face[1], 16u >> static_cast<unsigned>(0.6 * levels));
  }
}

/// Where faces of one level touch the pen stays down, and it goes to and fro.
TEST(Shading, HatchIsPlottable) {
  const Polylines lines = hatch(model(), {0, 0, 0}, 1);
  ASSERT_EQ(lines.size(), 32u);
  EXPECT_EQ(lines[0][0], Point2(2, 0.5));
  EXPECT_EQ(lines[0][1], Point2(9.5, 0.5));
  EXPECT_EQ(lines[2][0], Point2(14, 1.5));
  EXPECT_EQ(lines[2][1], Point2(12, 1.5));
}

TEST(Shading, NothingSeenIsWhite) {
  EXPECT_EQ(shade({}, {}, 2, 1, 1).gray, (std::vector<std::uint8_t>{255, 255}));
  EXPECT_EQ(hatch({}, {}, 4).size(), 0u);
}

}  // namespace
}  // namespace ligne
