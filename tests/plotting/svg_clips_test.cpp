/// Clip paths, masks, and paints and radii that come from elsewhere.

#include "plotting/paths/path_length.hpp"
#include "support/test.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

TEST(SvgClips, ClipPathsInheritFromWhereTheyAreWritten) {
  const std::string frame = "<path d='M10 10H90V90H10ZM30 30H70V70H30Z'/>", line = "<line y1='55' y2='55' x2='100' ";
  const Lines pieces{"1000,5500 3000,5500 ", "7000,5500 9000,5500 "};
  expect_lines("<g clip-rule='evenodd'><clipPath id='c'>" + frame + "</clipPath></g>" + line + "clip-path='url(#c)'/>",
               pieces);
  expect_lines("<clipPath id='c'>" + frame + "</clipPath><g clip-rule='evenodd'>" + line + "clip-path='url(#c)'/></g>",
               {"1000,5500 9000,5500 "}, "not from what is cut");
  expect_lines("<g fill-rule='evenodd' fill='white'><mask id='m'>" + frame + "</mask></g>" + line + "mask='url(#m)'/>",
               pieces);
}

TEST(SvgClips, OpacityDoesNotCountInAClipPath) {
  const std::string line = "<line y1='50' y2='50' x2='100' clip-path='url(#c)'/>";
  for (const char* look : {"opacity='0'", "fill-opacity='0'", "fill='none'", "style='opacity:0'"}) {
    expect_lines(std::string("<clipPath id='c'><rect x='20' y='20' width='60' height='60' ") + look + "/></clipPath>" + line,
                 {"2000,5000 8000,5000 "}, look);
  }
  for (const char* look :
       {"display='none'", "visibility='hidden'", "display='none' opacity='0'", "opacity='0' display='none'"}) {
    expect_lines(std::string("<clipPath id='c'><rect x='20' y='20' width='60' height='60' ") + look + "/></clipPath>" + line,
                 {}, look);
  }
}

TEST(SvgClips, MasksEndAtTheirRegion) {
  const auto masked = [](const std::string& region, const std::string& shape) {
    return "<mask id='m' " + region + "><rect width='100' height='100' fill='white'/></mask>" + shape;
  };
  const std::string line = "<line x1='10' y1='50' x2='90' y2='50' mask='url(#m)'/>";
  expect_lines(masked("maskUnits='userSpaceOnUse' x='0' y='0' width='50' height='100'", line), {"1000,5000 5000,5000 "});
  expect_lines(masked("maskUnits='userSpaceOnUse' width='50%' height='100%'", line), {"1000,5000 4000,5000 "},
               "from a tenth before the corner");
  expect_lines(masked("x='0' y='0' width='0.5' height='1'", "<path d='M20 20H60V60' mask='url(#m)'/>"),
               {"2000,2000 4000,2000 "}, "in units of the box");
  expect_lines(masked("x='0%' y='0%' width='75%' height='50%'", "<path d='M20 20L60 60' mask='url(#m)'/>"),
               {"2000,2000 4000,4000 "});
  expect_lines(masked("", line), {"1000,5000 9000,5000 "});
  expect_lines(
      "<mask id='m'><rect width='9' height='9' display='none'/><rect width='50' height='100' fill='white'/></mask>" + line,
      {"1000,5000 5000,5000 "}, "after one that is not displayed");
}

/// The outline of a fill is that of what is seen of it.
TEST(SvgClips, ClippedFillsEndWhereTheClipPathCutsThem) {
  const auto fill = [](const std::string& clip, const std::string& shape) {
    return "<clipPath id='c'>" + clip + "</clipPath><g stroke='none' fill='red'>" + shape + "</g>";
  };
  const ReadDrawing disc =
      read(fill("<circle cx='50' cy='50' r='30'/>", "<rect width='100' height='100' clip-path='url(#c)'/>"));
  ASSERT_EQ(disc.drawing.layers.size(), 1u);
  const Polylines& circle = disc.drawing.layers[0].lines;
  ASSERT_EQ(circle.size(), 1u);
  EXPECT_EQ(circle[0].front(), circle[0].back());
  for (const Point2 p : circle.points) EXPECT_NEAR(glm::distance(p, Point2(50, 50)), 30, 0.006);
  expect_lines(fill("<path d='M0 0H50V100H0Z'/>", "<rect x='20' y='20' width='60' height='40' clip-path='url(#c)'/>"),
               {"2000,2000 5000,2000 ", "5000,6000 2000,6000 2000,2000 ", "5000,2000 5000,6000 "});
  // A union of two parts: the borders inside it are none.
  const ReadDrawing two =
      read(fill("<rect x='10' y='30' width='30' height='30'/><rect x='30' y='30' width='30' height='30'/>",
                "<rect width='100' height='100' clip-path='url(#c)'/>"));
  double length = 0;
  for (std::size_t i = 0; i < two.drawing.layers.at(0).lines.size(); ++i)
    length += path_length(two.drawing.layers[0].lines[i]);
  EXPECT_NEAR(length, 2 * (50 + 30), 1e-6) << "what two sides have in common is drawn once";
  // Two clips, one inside the other.
  expect_lines(
      "<clipPath id='a'><rect width='50' height='100'/></clipPath><clipPath id='b'><rect width='100' height='40'/></clipPath>"
      "<g clip-path='url(#a)' stroke='none'><rect x='20' y='20' width='60' height='60' fill='red' clip-path='url(#b)'/></g>",
      {"2000,2000 5000,2000 ", "2000,4000 2000,2000 ", "5000,2000 5000,4000 ", "5000,4000 2000,4000 "});
}

TEST(SvgClips, AnEllipseOfOneRadiusIsACircle) {
  for (const char* radii : {"rx='30'", "ry='30'", "rx='30' ry='auto'", "rx='auto' ry='30'", "rx='30' ry='-1'"}) {
    const std::vector<Point2> line = line_of(std::string("<ellipse cx='50' cy='50' ") + radii + "/>");
    for (const Point2 p : line) EXPECT_NEAR(glm::distance(p, Point2(50, 50)), 30, 0.006) << radii;
    EXPECT_GT(line.size(), 20u) << radii;
  }
  expect_lines("<ellipse cx='50' cy='50'/><ellipse cx='50' cy='50' rx='0'/><ellipse rx='30' ry='0'/>", {});
}

TEST(SvgClips, PaintsOfTheContextComeFromTheUse) {
  const auto names = [](const std::string& body) {
    std::string all;
    for (const Layer& layer : read(body).drawing.layers) all += layer.name + " ";
    return all;
  };
  const std::string path =
      "<defs><path id='p' d='M10 10H90' stroke='context-stroke'/>"
      "<symbol id='s'><path d='M10 20H90' stroke='context-fill'/></symbol>"
      "<g id='g'><use href='#p' stroke='blue'/></g></defs>";
  EXPECT_EQ(names(path + "<use href='#p' stroke='red'/>"), "#ff0000 ");
  EXPECT_EQ(names(path + "<use href='#s' fill='lime'/>"), "#00ff00 ");
  EXPECT_EQ(names(path + "<use href='#g' stroke='red'/>"), "#0000ff ") << "of the nearest one";
  EXPECT_EQ(names(path + "<use href='#p' stroke='none'/>"), "");
}

}  // namespace
}  // namespace ligne
