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

/// Discs at random places: what is left of each rim is what no later disc covers, by their distances.
TEST(SvgReader, HiddenPartsAreExact) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(10, 90), size(2, 15);
  std::vector<Point3> discs;  // centre and radius
  std::ostringstream body;
  for (int i = 0; i < 60; ++i) {
    const Point3 disc{place(random), place(random), size(random)};
    discs.push_back(disc);
    body << "<g inkscape:groupmode='layer' inkscape:label='" << i << "'><circle cx='" << disc.x << "' cy='" << disc.y
         << "' r='" << disc.z << "' fill='red'/></g>";
  }
  const ReadDrawing read = read_svg_drawing(page(body.str()), "a.svg", {}, {FillReading::How::outline, 0.35, true});
  for (std::size_t i = 0; i < discs.size(); ++i) {
    constexpr int kSteps = 20'000;
    double seen = 0, length = 0;
    for (int k = 0; k < kSteps; ++k) {
      const double a = 2 * std::numbers::pi * k / kSteps;
      const Point2 p = Point2(discs[i]) + Point2{std::cos(a), std::sin(a)} * discs[i].z;
      const auto covers = [&](const Point3& disc) { return glm::distance(p, Point2(disc)) < disc.z; };
      seen += std::none_of(discs.begin() + static_cast<std::ptrdiff_t>(i) + 1, discs.end(), covers);
    }
    for (const Layer& layer : read.drawing.layers)
      if (layer.name == std::to_string(i)) length += measure(layer.lines, {0, 0}, false).down_mm;
    EXPECT_NEAR(length, seen / kSteps * 2 * std::numbers::pi * discs[i].z, 0.1) << i;
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

// SVG drawings read back, where scripts/svg_reader.txt can not say what is right.

TEST(SvgReader, CurvesOfHigherDegreesAreWhereTheyShouldBe) {
  // A parabola as a quadratic and as a cubic.
  for (const char* body :
       {"<path d='M0 0Q50 100 100 0'/>", "<path d='M0 0C33.3333333333 66.6666666667 66.6666666667 66.6666666667 100 0'/>",
        "<path d='M0 0q25 50 50 50t50-50'/>"}) {
    for (const Point2 p : line_of(body)) EXPECT_NEAR(p.y, 2 * p.x * (1 - p.x / 100), 1e-6) << body;
  }
  const std::vector<Point2> smooth = line_of("<path d='M0 50C0 30 20 30 20 50S40 70 40 50'/>");
  for (const Point2 p : smooth)
    if (p.x > 20.5 && p.x < 39.5) {
      EXPECT_GT(p.y, 50) << "S mirrors the control point";
    }
}

TEST(SvgReader, DotsAndFills) {
  Drawing dots;
  add_line(dots, "outline", {{5, 5}, {5, 5}});
  EXPECT_EQ(lines_of(read_svg_drawing(write_svg(dots, {}), "a.svg", {})), Lines{"500,500 500,500 "}) << "ours come back";
  const std::string square =
      page("<path d='M10 10h20v20h-20zM15 15h10v10h-10z' fill='red' stroke='none'/><text x='1' y='9'>a</text>");
  const auto with = [&](FillReading::How how) { return read_svg_drawing(square, "a.svg", {}, {how, 0.5}); };
  EXPECT_EQ(with(FillReading::How::outline).drawing.layers.at(0).lines.size(), 1u) << "wound alike: no border inside";
  EXPECT_GT(measure(with(FillReading::How::hatch).drawing.layers.at(0).lines, {0, 0}, false).down_mm, 400 / 0.4 * 0.9)
      << "wound alike: no hole";
  EXPECT_EQ(read_svg_drawing(square, "a.svg", {}).outlined, 1u) << "and it is said";
  EXPECT_THROW(with(FillReading::How::refuse), std::runtime_error);
}

TEST(SvgReader, LeavesOutWhatMayBeLeftOut) {
  const ReadDrawing drawing =
      read_svg_drawing(page("<image/><image/><path d='M0 0L9 0 9 9z' fill='red'/>"), "a.svg", {"image", "fill"});
  EXPECT_EQ(drawing.left_out.at("image"), 2u);
  EXPECT_EQ(drawing.left_out.at("fill"), 1u);
  EXPECT_EQ(drawing.drawing.layers.at(0).lines.size(), 1u);
}

}  // namespace
}  // namespace ligne
