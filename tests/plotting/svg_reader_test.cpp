/// SVG drawings read back, where scripts/svg_reader.txt can not say what is right.

#include "sample_drawing.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

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

TEST(SvgReader, StyleSheetsOfTooMuchWorkAreRefused) {
  std::string many = "<style>";
  for (int i = 0; i < 9000; ++i) many += "* line{stroke:red}";
  std::string nest, crowd;
  for (int i = 0; i < 100; ++i) nest += "<g>", crowd += "</g>";
  for (int i = 0; i < 12'000; ++i) nest += "<line x2='1'/>";
  EXPECT_NE(error_of(page(many + "</style>" + nest + crowd)).find("too much work"), std::string::npos);
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

TEST(SvgReader, DeepElementsAreLeftOut) {
  std::string deep, end;
  for (int i = 0; i < 5000; ++i) deep += "<g>", end += "</g>";
  const ReadDrawing drawing = read(deep + "<line x2='9'/>" + end + "<line x2='5'/>");
  EXPECT_EQ(lines_of(drawing), Lines{"0,0 500,0 "});
  EXPECT_EQ(drawing.omitted.list(), "1 element nested deeper than 200 elements");
}

TEST(SvgReader, ManyShapesOfAClipPathAreClippedOneByOne) {
  std::string clip = "<clipPath id='left'><rect width='50' height='100'/></clipPath><clipPath id='c'>";
  Lines seen;
  for (int x = 0; x < 100; x += 4) {
    clip += "<rect x='" + std::to_string(x) + "' width='2' height='100' clip-path='url(#left)'/>";
    if (x < 50) seen.insert(std::to_string(100 * x) + ",2000 " + std::to_string(100 * std::min(x + 2, 50)) + ",2000 ");
  }
  expect_lines(clip + "</clipPath><line y1='20' x2='100' y2='20' clip-path='url(#c)'/>", seen);
}

// SVG documents as programs write them: entities, units, crowds.

ReadDrawing read_document(const std::string& text, double px_per_inch = 96) {
  return read_svg_drawing(text, "a.svg", {}, {}, {.px_per_inch = px_per_inch});
}

const std::string kSize = " width='100mm' height='100mm' viewBox='0 0 100 100' fill='none' stroke='black'>";

TEST(SvgDocuments, EntitiesDoNotGrowWithoutBounds) {
  const auto failure = [](const std::string& declarations) {
    return failure_of(
        [&] { read_document("<!DOCTYPE svg [" + declarations + "]><svg" + kSize + "<text>&z;</text></svg>"); });
  };
  EXPECT_NE(failure("<!ENTITY z '&z;'>").find("contain each other"), std::string::npos);
  EXPECT_NE(failure("<!ENTITY z '&y;&y;'><!ENTITY y '&z;'>").find("contain each other"), std::string::npos);
  std::string bomb = "<!ENTITY a0 'ha'>", empty = "<!ENTITY a0 ''>", last;
  for (int i = 1; i < 16; ++i) {
    std::string value;
    for (int k = 0; k < 10; ++k) value += "&a" + std::to_string(i - 1) + ";";
    last = "<!ENTITY " + (i == 15 ? "z" : "a" + std::to_string(i)) + " '" + value + "'>";
    bomb += last;
    empty += last;
  }
  EXPECT_NE(failure(bomb).find("entities"), std::string::npos);
  EXPECT_NE(failure(empty).find("four million references"), std::string::npos);
}

TEST(SvgDocuments, CrowdsOfSiblingsAreNumberedOnce) {
  std::string body = "<style>line:nth-child(2n+1){stroke:none}</style>";
  constexpr int kLines = 40'000;
  for (int i = 0; i < kLines; ++i) body += "<line x2='1'/>";
  EXPECT_EQ(lines_of(read(body)).size(), kLines / 2u);
}

TEST(SvgDocuments, VariablesDoNotGrowWithoutBounds) {
  std::string bomb = "--a0:xxxxxxxxxxxxxxxx;";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "var(--a" + std::to_string(i - 1) + ")";
    bomb += "--a" + std::to_string(i) + ":" + before + before + ";";
  }
  EXPECT_EQ(read("<line x2='5' style='" + bomb + "stroke:var(--a39)'/>").omitted.list(),
            "1 value of stroke that is not known");
}

}  // namespace
}  // namespace ligne
