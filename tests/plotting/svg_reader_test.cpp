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
