/// Lines and areas as the SVG has them after Cairo drew them.

#include <cctype>

#include "base/parallel.hpp"
#include "main/script.hpp"
#include "plotting/readers/drawing_reader.hpp"
#include "plotting/writers/cairo_svg_parts.hpp"
#include "plotting/writers/writers.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

TEST(SvgPaths, DashesStayDashesHoweverShort) {
  for (const double width : {0.001, 0.1, 50.0}) {
    Drawing drawing;
    add_line(drawing, "hidden", {{10, 10}, {100, 10}});
    PlotOptions options;
    options.pen_width_mm = width;
    const std::string svg = write_svg(drawing, options);
    EXPECT_EQ(path_data(svg), std::vector<std::string>{"M10 10l90 0"});
    test::expect_parts(svg, {"stroke-dasharray=\""});
  }
}

TEST(SvgPaths, ManyAreasTakeNoTimeWithTheSquareOfTheirNumber) {
  Drawing drawing;
  for (int i = 0; i < 30000; ++i) {
    const double x = i % 200, y = i / 200;
    drawing.fills.push_back({{{{x, y}, {x + 1, y}, {x, y + 1}}}, {i % 256 / 255.0, 0, 0}});
  }
  EXPECT_EQ(path_data(write_svg(drawing, {})).size(), 30000u);
}

/// Documents of Cairo 1.16 and 1.18 taken apart, and what is refused. tests/plotting/cairo/make_sample.py wrote the samples.

std::string sample(const std::string& version) {
  return test::bytes_of_file(LIGNE_SOURCE_DIR "/tests/plotting/cairo/cairo-" + version + ".svg");
}

std::string commands_of(const CairoSvgPart& part) {
  std::string text;
  for_each_command(part, [&](char command, const Point2* points) {
    text += command;
    for (int i = 0; i < (command == 'Z' ? 0 : command == 'C' ? 3 : 1); ++i)
      text += std::to_string(std::lround(points[i].x * 10)) + "," + std::to_string(std::lround(points[i].y * 10)) + " ";
  });
  return text;
}

class CairoSvgParts : public testing::TestWithParam<const char*> {};

TEST_P(CairoSvgParts, TheSampleHasItsPartsInOrder) {
  std::string document = sample(GetParam());
  const std::vector<CairoSvgPart> parts = cairo_svg_parts(document, 2000);
  ASSERT_EQ(parts.size(), 5u);
  EXPECT_EQ(parts[0].image.substr(0, 33), "data:image/png;base64,iVBORw0KGgo");
  EXPECT_EQ(parts[0].to_document({0, 0}), (Point2{100, 200}));
  EXPECT_EQ(parts[0].to_document(parts[0].pixels), (Point2{250, 250}));

  EXPECT_EQ(parts[1].fill, "#804000");
  EXPECT_EQ(parts[1].stroke, "#804000") << "its rim";
  EXPECT_EQ(parts[1].fill_opacity, 1);
  EXPECT_EQ(commands_of(parts[1]),
            "M12500,12500 L17500,12500 L17500,17500 L12500,17500 ZM13750,13750 L16250,13750 L16250,16250 L13750,16250 "
            "ZM13750,13750 ");

  EXPECT_EQ(parts[2].fill, "#ff0000");
  EXPECT_FALSE(parts[2].stroke);
  EXPECT_EQ(parts[2].fill_opacity, 0.3);
  EXPECT_EQ(commands_of(parts[2]), "M5000,5000 L7500,5000 L7500,7500 L5000,7500 ZM5000,5000 ");

  EXPECT_FALSE(parts[3].fill);
  EXPECT_EQ(parts[3].stroke, "#000000");
  EXPECT_EQ(commands_of(parts[3]),
            "M11250,12500 L7500,15000 L7000,11235 M15000,15000 L15000,15000 M10000,10000 L12500,10000 L12500,12500 "
            "ZM15000,10000 C15000,12500 12500,15000 10000,15000 ");
  EXPECT_EQ(commands_of(parts[4]), "M100,200 L305,400 ") << "without a transform, and dashed";
}

INSTANTIATE_TEST_SUITE_P(Versions, CairoSvgParts, testing::Values("1.16", "1.18"),
                         [](const auto& info) { return info.index == 0 ? "Cairo116" : "Cairo118"; });

/// The commands of all parts.
std::string parts_in(std::string document) {
  std::string text;
  for (const CairoSvgPart& part : cairo_svg_parts(document, 2000)) text += commands_of(part);
  return text;
}

/// The functions of cairo_values.
const test::TextFunctions kCairoFunctions{
    {"document", parts_in},
    {"body",
     [](auto& t) { return parts_in("<svg width='2000pt' height='2000pt' viewBox='0 0 2000 2000'>" + t + "</svg>"); }},
};

[[maybe_unused]] const bool cairo_values_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/plotting/cairo_values", kCairoFunctions);

/// Arcs in files: Bezier curves.

Drawing circle_drawing(const Ellipse& ellipse) {
  Drawing drawing;
  drawing.layers.push_back({"outline", {}});
  drawing.layers.back().lines.add(closed(ellipse, 60));
  return drawing;
}

/// The points of the only path, curves followed in steps: M, L, C, S, their relative forms, and Z.
std::vector<Point2> followed(const std::string& svg, int& curves) {
  const std::string data = path_data(svg).at(0);
  std::string spaced;
  for (const char c : data)
    spaced += std::isalpha(static_cast<unsigned char>(c)) ? std::string{' ', c, ' '} : c == '-' ? " -" : std::string{c};
  std::istringstream in(spaced);
  std::vector<Point2> points;
  char command = 0;
  Point2 at{0, 0}, handle{0, 0};
  while (in >> std::ws && !in.eof()) {
    if (std::isalpha(in.peek())) in >> command;
    if (command == 'Z') break;
    const char kind = static_cast<char>(std::toupper(command));
    const auto point = [&] {
      Point2 p{0, 0};
      in >> p.x >> p.y;
      return std::islower(command) ? at + p : p;
    };
    if (kind == 'C' || kind == 'S') {
      ++curves;
      const Point2 a = kind == 'C' ? point() : at + (at - handle), b = point(), to = point();
      for (int i = 0; i < 1000; ++i) {
        const double t = i / 1000.0, u = 1 - t;
        points.push_back(u * u * u * at + 3 * u * u * t * a + 3 * u * t * t * b + t * t * t * to);
      }
      handle = b;
      at = to;
    } else {
      EXPECT_TRUE(kind == 'M' || kind == 'L') << command;
      at = point();
    }
    points.push_back(at);
  }
  return points;
}

TEST(CurvesInFiles, SvgCurvesAreTheEllipse) {
  PlotOptions options;
  options.curves = true;
  for (const double turn : {0.0, 25.0, 90.0, 140.0}) {
    for (const double slender : {1.0, 0.6, 0.05}) {
      const Ellipse ellipse{{101, 90}, {20, 20 * slender}, turn * kDegree};
      int curves = 0;
      const std::string svg = write_svg(circle_drawing(ellipse), options);
      const std::vector<Point2> points = followed(svg, curves);
      EXPECT_GE(curves, 6) << svg;
      EXPECT_LE(curves, 12) << svg;
      const EllipseFrame frame(ellipse);
      for (const Point2 p : points) EXPECT_LE(frame.distance(frame.to_unit(p)), kCurveToleranceMm);
      for (const Point2 p : closed(ellipse, 60))
        EXPECT_LE(test::distance_to_lines(p, polylines_of({points})), kCurveToleranceMm);
    }
  }
}

TEST(CurvesInFiles, OffUnlessAskedForAndNotForLetters) {
  Drawing drawing = circle_drawing({{100, 90}, {20, 20}});
  int count = 0;
  followed(write_svg(drawing, {}), count);
  EXPECT_EQ(count, 0);
  PlotOptions curves;
  curves.curves = true;
  EXPECT_LT(write_svg(drawing, curves).size(), write_svg(drawing, {}).size());
  EXPECT_NE(write_pdf(drawing, curves), write_pdf(drawing, {}));
  EXPECT_NE(write_png(drawing, curves), write_png(drawing, {}));
  drawing.layers[0].name = "text";
  EXPECT_EQ(write_svg(drawing, curves), write_svg(drawing, {}));
  EXPECT_EQ(write_pdf(drawing, curves), write_pdf(drawing, {}));
}

TEST(CurvesInFiles, TheSameForAnyNumberOfThreads) {
  Drawing drawing = circle_drawing({{100, 90}, {20, 9}, 0.3});
  for (int i = 0; i < 400; ++i)
    drawing.layers[0].lines.add(closed({{100, 90}, {0.2 + i * 0.1, 0.2 + i * 0.07}, i * 0.1}, 60));
  for (int i = 0; i < 30000; ++i)
    add_line(drawing, "mesh", {{i % 199 * 1.01, i % 283 * 1.03}, {i % 97 * 2.1, i % 139 * 2.1}});
  PlotOptions options;
  options.curves = true;
  std::string files[2];
  for (const unsigned threads : {1u, 4u})
    run_with_threads(threads, [&] {
      files[threads / 4] = write_svg(drawing, options) + write_svg(drawing, {}) + write_pdf(drawing, options);
    });
  EXPECT_TRUE(files[0] == files[1]);
}

}  // namespace
}  // namespace ligne
