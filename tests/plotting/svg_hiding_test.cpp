/// Hiding by clip paths, masks and filled areas of an SVG drawing.

#include "drawing/measures.hpp"
#include "main/tier.hpp"
#include "plotting/meant_areas.hpp"
#include "sample_drawing.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

// Areas that abut, coincide and overlap, held against a sampled picture: who is on top is told point by point, from the
// shapes as they were meant, without anything of the code under test.

void expect_right(MeantScene (*make)(Dice&), unsigned seed, int all = 10'000) {
  SeededDice dice(seed);
  const int count = runs_all() ? all : all / 33;
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    const MeantScene scene = make(dice);
    if (wrong_places(scene, dice) == 0) continue;
    if (++wrong == 1) ADD_FAILURE() << "the first that is wrong: " << svg_of(scene);
  }
  EXPECT_EQ(wrong, 0) << "of " << count;
}

TEST(SvgAreas, AbuttingRectanglesAgreeWithAPicture) { expect_right(abutting_rectangles, 1); }
TEST(SvgAreas, PolygonsOfSharedCornersAgreeWithAPicture) { expect_right(polygons_of_shared_corners, 2); }

TEST(SvgAreas, ScribblesAgreeWithAPicture) { expect_right(scribbles, 4, 1'000); }

// Hiding by clip paths, masks and filled areas of an SVG drawing.

/// Discs at random places: what is left of each rim is what no later disc covers, by their distances.
TEST(SvgReader, HiddenPartsAreExact) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(10, 90), size(2, 15);
  struct Disc {
    Point2 at;
    double r;
  };
  std::vector<Disc> discs;
  std::string body;
  for (int i = 0; i < 60; ++i) {
    discs.push_back({{place(random), place(random)}, size(random)});
    body += "<g inkscape:groupmode='layer' inkscape:label='" + std::to_string(i + 1) + "'><circle cx='" +
            std::to_string(discs.back().at.x) + "' cy='" + std::to_string(discs.back().at.y) + "' r='" +
            std::to_string(discs.back().r) + "' fill='red'/></g>";
  }
  const ReadDrawing read = read_svg_drawing(page(body), "a.svg", {}, {FillReading::How::outline, 0.35, true});
  for (std::size_t i = 0; i < discs.size(); ++i) {
    double expected = 0;
    constexpr int kSteps = 20'000;
    for (int k = 0; k < kSteps; ++k) {
      const double a = 2 * std::numbers::pi * k / kSteps;
      const Point2 p = discs[i].at + Point2{std::cos(a), std::sin(a)} * discs[i].r;
      bool seen = true;
      for (std::size_t later = i + 1; later < discs.size(); ++later)
        seen = seen && glm::distance(p, discs[later].at) >= discs[later].r;
      if (seen) expected += 2 * std::numbers::pi * discs[i].r / kSteps;
    }
    double length = 0;
    for (const Layer& layer : read.drawing.layers)
      if (layer.name == std::to_string(i + 1)) length += measure(layer.lines, {0, 0}, false).down_mm;
    EXPECT_NEAR(length, expected, 0.1) << i;
  }
}

/// Drawings as files: of other programs, hostile ones, our own, and in JSON.

TEST(SvgReader, TooManyHatchesAreRefused) {
  std::string areas;
  for (int i = 0; i < 5'000; ++i) areas += "<path d='M0 0H1000000V1000000H0z' fill='red' stroke='none'/>";
  EXPECT_THROW(read_svg_drawing(page(areas), "a.svg", {}, {FillReading::How::hatch, 0.01}), std::runtime_error);
}

TEST(JsonDrawingReader, ReadsWhatWeWrite) {
  const StrokeModel strokes = sample_strokes();
  DrawingDocument document;
  document.strokes = &strokes;
  document.source = [&](std::uint32_t source) { return sample_source(strokes, source); };
  const ReadDrawing back = read_json_drawing(write_json(document, {}), "a.json");
  EXPECT_EQ(back.page.height_mm, 297);
  ASSERT_EQ(back.drawing.layers.size(), 2u);
  EXPECT_EQ(back.drawing.layers[0].name, "hidden");
  EXPECT_EQ(back.drawing.layers[1].name, "outline");
  EXPECT_NEAR(glm::distance(back.drawing.layers[1].lines[0][1], Point2(110, 100.125)), 0, 1e-9);
}

TEST(JsonDrawingReader, RefusesWhatIsDeep) {
  EXPECT_THROW(read_json_drawing(std::string(200'000, '['), "a.json"), std::runtime_error);
}

std::string rect_text(const char* name, Point2 at, Point2 size, const std::string& more) {
  std::ostringstream text;
  text << "<" << name << " x='" << at.x << "' y='" << at.y << "' width='" << size.x << "' height='" << size.y << "' "
       << more;
  return text.str();
}

/// Points on the border of a frame that are drawn and hidden, or neither, by a white area that begins at its corner or side.
int wrong_points_of_frame(std::mt19937& random) {
  const auto number = [&](double from, double to) {
    return std::round(std::uniform_real_distribution<double>(from, to)(random) * 1e4) / 1e4;
  };
  const Point2 at{number(20, 40), number(20, 40)}, size{number(10, 40), number(10, 40)};
  const Point2 white_size{number(5, 50), number(5, 50)};
  Point2 white{number(5, 80), number(5, 80)};
  const int side = static_cast<int>(random() % 4), axis = side % 2;
  white[axis] = side < 2 ? at[axis] + size[axis] : at[axis] - white_size[axis];
  if (random() % 4 == 0) white[axis] = at[axis];  // inside it, along a side
  const Point2 shift = random() % 2 ? Point2{number(-9, 9), number(-9, 9)} : Point2{0, 0};
  const double clip_end = random() % 3 ? 1000 : white.x + white_size.x / 2;
  const std::string filled = "fill='white' stroke='none'",
                    clip = "<clipPath id='c'>" +
                           rect_text("rect", {0, 0}, {clip_end, 100}, "/></clipPath><g clip-path='url(#c)'>");
  std::ostringstream moved;
  moved.precision(17);
  moved << "<g transform='translate(" << shift.x << " " << shift.y << ")'>";
  const std::string area =
      random() % 2 ? moved.str() + rect_text("rect", white - shift, white_size, filled + "/></g>")
                   : rect_text("svg", white, white_size, "><rect width='100%' height='100%' " + filled + "/></svg>");
  const ReadDrawing drawn = read(rect_text("rect", at, size, "/>") + clip + area + "</g>");
  Polylines none;
  const Polylines& lines = drawn.drawing.layers.empty() ? none : drawn.drawing.layers[0].lines;
  constexpr double kNear = 1e-3;
  const Point2 low = white, high{std::min(white.x + white_size.x, clip_end), white.y + white_size.y};
  Polylines frame;
  frame.add(std::vector<Point2>{at, at + Point2{size.x, 0}, at + size, at + Point2{0, size.y}, at});
  int wrong = 0;
  for (int k = 0; k < 200; ++k) {
    const Point2 a = frame.points[static_cast<std::size_t>(k / 50)], b = frame.points[static_cast<std::size_t>(k / 50) + 1];
    const Point2 p = a + (b - a) * (k % 50 / 50.0);
    const double depth = std::min(std::min(p.x - low.x, high.x - p.x), std::min(p.y - low.y, high.y - p.y));
    // The border of the area hides nothing: half of the ink lies beside it.
    if (depth > kNear && depth < 2 * kNear) continue;
    wrong += (distance_to_lines(p, lines) <= kNear) == (depth > kNear);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 1; k < lines[i].size(); ++k)
      wrong += distance_to_lines((lines[i][k - 1] + lines[i][k]) / 2.0, frame) > kNear;
  return wrong;
}

TEST(SvgReader, AreasThatAbutStrokesTakeNoCorners) {
  std::mt19937 random(7);
  const int count = runs_all() ? 10'000 : 400;
  int wrong = 0;
  for (int i = 0; i < count; ++i) wrong += wrong_points_of_frame(random) > 0;
  EXPECT_EQ(wrong, 0) << "of " << count;
}

}  // namespace
}  // namespace ligne
