// Spans put together to areas.

#include "drawing/shading.hpp"
#include "drawing/span_areas.hpp"
#include "measures.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

double area(const Region& region) { return std::abs(test::area_of(region)); }

double area_of(const std::vector<Region>& regions, std::uint32_t face) {
  return std::accumulate(regions.begin(), regions.end(), 0.0,
                         [&](double sum, const Region& r) { return r.face == face ? sum + area(r) : sum; });
}

/// The outer contour has a corner within `within` of each of these places.
void expect_corners(const Region& region, std::initializer_list<Point2> corners, double within) {
  for (const Point2 at : corners) {
    double least = 1e9;
    for (const Point2 p : region.contours.at(0)) least = std::min(least, glm::distance(p, at));
    EXPECT_LT(least, within) << at.x << " " << at.y;
  }
}

/// Lines half a millimetre apart, with the spans that `of_height` gives.
SpanModel scanned(const std::function<std::vector<Span>(double)>& of_height) {
  SpanModel model{{0.25, 0.5, 100}, {}};
  for (std::uint32_t line = 0; line < model.lines.count; ++line)
    for (Span span : of_height(model.lines.y_mm(line))) {
      span.line = line;
      if (span.x_from < span.x_to) model.spans.push_back(span);
    }
  return model;
}

constexpr double kRightMm = 0.002;  ///< sides are straight to a micrometre on either side of the ends of spans

TEST(SpanAreas, CornersBetweenTheLinesAreFoundWhereSidesMeet) {
  // A kite: (20, 3.1), (31, 17.4), (20, 40.6), (11, 12.9).
  const SpanModel model = scanned([](double y) {
    if (y < 3.1 || y > 40.6) return std::vector<Span>{};
    const double left = y < 12.9 ? 20 - 9 * (y - 3.1) / 9.8 : 11 + 9 * (y - 12.9) / 27.7;
    const double right = y < 17.4 ? 20 + 11 * (y - 3.1) / 14.3 : 31 - 11 * (y - 17.4) / 23.2;
    return std::vector<Span>{{0, left, right, 7}};
  });
  const std::vector<Region> areas = areas_of_spans(model);
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_EQ(areas[0].face, 7u);
  ASSERT_EQ(areas[0].contours.size(), 1u);
  expect_corners(areas[0], {{20, 3.1}, {31, 17.4}, {20, 40.6}, {11, 12.9}}, kRightMm);
  EXPECT_LE(areas[0].contours[0].size(), 10u);
  EXPECT_NEAR(area(areas[0]), 20 * 37.5 / 2, 0.1);
}

TEST(SpanAreas, LevelBordersLieHalfWayBetweenTwoLines) {
  const std::vector<Region> areas = areas_of_spans(scanned([](double y) {
    return y < 10 || y > 20 ? std::vector<Span>{} : std::vector<Span>{{0, 5, 8, 0}};
  }));
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_NEAR(area(areas[0]), 30, 1e-9);
  expect_corners(areas[0], {{5, 10}, {8, 10}, {8, 20}, {5, 20}}, 1e-9);
}

/// A face before another divides it: no part of it is lost, and none is there twice.
TEST(SpanAreas, AFaceBehindAnother) {
  const SpanModel model = scanned([](double y) {
    if (y < 5 || y > 45) return std::vector<Span>{};
    const double half = 10 - std::abs(y - 25.1);  // a square on its corner in the middle of a square
    if (half <= 0) return std::vector<Span>{{0, 5, 45, 1}};
    return std::vector<Span>{{0, 5, 25 - half, 1}, {0, 25 - half, 25 + half, 2}, {0, 25 + half, 45, 1}};
  });
  const std::vector<Region> areas = areas_of_spans(model);
  EXPECT_EQ(areas.size(), 5u);
  EXPECT_NEAR(area_of(areas, 2), 200, 0.01);
  EXPECT_NEAR(area_of(areas, 1), 1400, 0.5);
  for (const Region& region : areas)
    if (region.face == 2) expect_corners(region, {{25, 15.1}, {35, 25.1}, {25, 35.1}, {15, 25.1}}, kRightMm);
}

TEST(SpanAreas, TwoPartsOfOneFaceOneBelowTheOther) {
  const std::vector<Region> areas = areas_of_spans(scanned([](double y) {
    return (y > 10 && y < 12) || (y > 13 && y < 15) ? std::vector<Span>{{0, 5, 8, 0}} : std::vector<Span>{};
  }));
  EXPECT_EQ(areas.size(), 2u);
  EXPECT_NEAR(area_of(areas, 0), 12, 1e-9);
}

TEST(SpanAreas, OfNothing) { EXPECT_TRUE(areas_of_spans({}).empty()); }

// Spans as gray pixels.

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

/// Three faces: black, gray and white.
const auto kTone = [](SeenFace seen, Point2) { return std::array{std::array{0.0, 0.6, 1.0}.at(seen.face)}; };
using Gray = std::vector<std::uint8_t>;

/// These pixels, each by its number and what it has.
void expect_pixels(const FacePicture& picture, std::initializer_list<std::pair<std::size_t, int>> pixels) {
  for (const auto& [number, gray] : pixels) EXPECT_EQ(picture.gray.at(number), gray) << "pixel " << number;
}

TEST(Shading, PixelsAreMixedAtTheEndsOfSpans) {
  const FacePicture p = paint<1>(spans(), kTone, 16, 16, 1);
  ASSERT_EQ(p.gray.size(), 256u);
  // The span covers half of pixel 9.
  expect_pixels(p, {{0, 255}, {2, 0}, {5, 0}, {6, 153}, {9, 204}, {10, 255}, {12, 255}});
}

TEST(Shading, SpansBesideThePictureAreCut) {
  SpanModel m;
  m.lines = {0, 1, 9};
  m.spans = {{0, -5, 100, 0}, {7, 0, 1, 0}};
  const FacePicture p = paint<1>(m, kTone, 3, 2, 1);
  EXPECT_EQ(p.gray, (Gray{0, 0, 0, 255, 255, 255}));
}

TEST(Shading, NothingSeenIsWhite) { EXPECT_EQ(paint<1>(SpanModel{}, kTone, 2, 1, 1).gray, (Gray{255, 255})); }

/// Two by two pixels of a millimetre, the first at (1, 1) of the page; nothing is seen in the last.
PixelModel pixels() { return {2, 2, {1, 1}, 1, {0, 1, 2, 0xffffffffu}, {0, 0, 0, 0}}; }

TEST(Shading, PixelsOfTheSameSizeAreCopied) {
  EXPECT_EQ(paint<1>(pixels(), kTone, 4, 3, 1).gray, (Gray{255, 255, 255, 255, 255, 0, 153, 255, 255, 255, 255, 255}));
}

TEST(Shading, PixelsOfAnotherSizeAreMixed) {
  // The one pixel of 4 mm covers all four: 1 - (1 + 0.4) / 16.
  EXPECT_EQ(paint<1>(pixels(), kTone, 1, 1, 0.25).gray, (Gray{233}));
  expect_pixels(paint<1>(pixels(), kTone, 8, 6, 2),
                {{2 * 8 + 1, 255}, {2 * 8 + 2, 0}, {3 * 8 + 3, 0}, {3 * 8 + 4, 153}, {3 * 8 + 6, 255}});
}

TEST(Shading, PixelsThatStayWhereTheyLie) {
  PixelModel model = pixels();
  model.pixel_mm = 0.5;
  const FacePicture p = paint_each<1>(model, kTone);
  EXPECT_EQ(p.gray, (Gray{0, 153, 255, 255}));
  EXPECT_EQ(p.width, 2u);
  EXPECT_EQ(p.corner_mm, (Point2{1, 1}));
  EXPECT_EQ(p.pixel_mm, 0.5);
}

/// Lists with the same faces have one number, in one set of layers and in those merged from several.
TEST(TransparentLayers, EqualListsHaveOneNumber) {
  TransparentLayers layers;
  EXPECT_TRUE(layers.empty());
  const std::uint32_t back = layers.over(7, TransparentLayers::kEmptyList), both = layers.over(3, back);
  EXPECT_EQ(layers.over(7, TransparentLayers::kEmptyList), back);
  EXPECT_EQ(layers.over(3, back), both);
  EXPECT_NE(layers.over(3, TransparentLayers::kEmptyList), both);
  std::vector<std::uint32_t> faces;
  layers.for_each(both, [&](std::uint32_t face) { faces.push_back(face); });
  EXPECT_EQ(faces, (std::vector<std::uint32_t>{3, 7}));
  TransparentLayers other;
  const std::uint32_t same = other.over(3, other.over(7, TransparentLayers::kEmptyList));
  const std::vector<std::uint32_t> numbers = layers.merge(other);
  EXPECT_EQ(numbers[same], both);
  EXPECT_EQ(numbers[TransparentLayers::kEmptyList], TransparentLayers::kEmptyList);
}

/// Two panes of opacity 0.4 and 0.5 before black, and before paper.
TEST(TransparentLayers, ColoursAreComposedFromFrontToBack) {
  TransparentLayers layers;
  const std::uint32_t list = layers.over(1, layers.over(2, TransparentLayers::kEmptyList));
  const std::array<std::array<double, 3>, 3> colors = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}};
  const std::array<double, 3> opacities = {1, 0.4, 0.5};
  const auto color_of = [&](std::uint32_t face) { return colors[face]; };
  const auto opacity_of = [&](std::uint32_t face) { return opacities[face]; };
  const std::array<double, 3> before_black = seen_color<3>(layers, {0, list}, color_of, opacity_of);
  const std::array<double, 3> before_paper = seen_color<3>(layers, {kNone, list}, color_of, opacity_of);
  const std::array<double, 3> expected = {0.4, 0.3, 0.15};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(before_black[c], expected[c], 1e-15);
    EXPECT_NEAR(before_paper[c], expected[c] + 0.3, 1e-15);
  }
}

/// Spans of one face behind different lists make different areas; pixels make spans likewise.
TEST(SpanAreas, EndWhereTheTransparentFacesInFrontDo) {
  SpanModel model{{0.5, 1, 10}, {}};
  const std::uint32_t pane = model.layers.over(4, TransparentLayers::kEmptyList);
  for (std::uint32_t line = 0; line < 10; ++line) {
    model.spans.push_back({line, 0, 3, 1});
    model.spans.push_back({line, 3, 5, 1, pane});
    model.spans.push_back({line, 5, 8, kNone, pane});
  }
  const std::vector<Region> areas = areas_of_spans(model);
  ASSERT_EQ(areas.size(), 3u);
  for (const Region& area : areas) {
    const double left = area.contours[0][0].x;
    EXPECT_EQ(area.in_front, left < 3 ? TransparentLayers::kEmptyList : pane);
    EXPECT_EQ(area.face, left < 5 ? 1 : kNone);
  }
  PixelModel pixels{4, 1, {0, 0}, 1, {1, 1, kNone, kNone}, {0, 0, 0, 0}};
  pixels.layers = model.layers;
  pixels.in_front = {0, pane, pane, 0};
  const SpanModel spans = spans_of_pixels(pixels);
  ASSERT_EQ(spans.spans.size(), 3u);
  EXPECT_EQ(spans.spans[0].in_front, TransparentLayers::kEmptyList);
  EXPECT_EQ(spans.spans[1].in_front, pane);
  EXPECT_EQ(spans.spans[2].face, kNone);
}

}  // namespace
}  // namespace ligne
