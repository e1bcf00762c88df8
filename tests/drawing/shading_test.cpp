// Spans as gray pixels.

#include <gtest/gtest.h>

#include "drawing/shading.hpp"

namespace ligne {
namespace {

SpanModel spans() {
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
  const GrayPicture p = shade(spans(), kBrightness, 16, 16, 1);
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

TEST(Shading, NothingSeenIsWhite) { EXPECT_EQ(shade(SpanModel{}, {}, 2, 1, 1).gray, (std::vector<std::uint8_t>{255, 255})); }

/// Two by two pixels of a millimetre, the first at (1, 1) of the page; nothing is seen in the last.
PixelModel pixels() { return {2, 2, {1, 1}, 1, {0, 1, 2, 0xffffffffu}, {0, 0, 0, 0}}; }

TEST(Shading, PixelsOfTheSameSizeAreCopied) {
  const GrayPicture p = shade(pixels(), kBrightness, 4, 3, 1);
  EXPECT_EQ(p.gray, (std::vector<std::uint8_t>{255, 255, 255, 255, 255, 0, 153, 255, 255, 255, 255, 255}));
}

TEST(Shading, PixelsOfAnotherSizeAreMixed) {
  // The one pixel of 4 mm covers all four: 1 - (1 + 0.4) / 16.
  EXPECT_EQ(shade(pixels(), kBrightness, 1, 1, 0.25).gray, (std::vector<std::uint8_t>{233}));
  const GrayPicture fine = shade(pixels(), kBrightness, 8, 6, 2);
  EXPECT_EQ(fine.gray[2 * 8 + 1], 255);
  EXPECT_EQ(fine.gray[2 * 8 + 2], 0);
  EXPECT_EQ(fine.gray[3 * 8 + 3], 0);
  EXPECT_EQ(fine.gray[3 * 8 + 4], 153);
  EXPECT_EQ(fine.gray[3 * 8 + 6], 255);
}

TEST(Shading, PixelsThatStayWhereTheyLie) {
  PixelModel model = pixels();
  model.pixel_mm = 0.5;
  const GrayPicture p = gray_pixels(model, kBrightness);
  EXPECT_EQ(p.gray, (std::vector<std::uint8_t>{0, 153, 255, 255}));
  EXPECT_EQ(p.width, 2u);
  EXPECT_EQ(p.corner_mm, (Point2{1, 1}));
  EXPECT_EQ(p.pixel_mm, 0.5);
}

}  // namespace
}  // namespace ligne
