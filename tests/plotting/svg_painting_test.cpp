/// Order of painting, translucent groups and paints, and outlines of what is painted.

#include "support/test.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

Lines occluded(const std::string& body) {
  FillReading fills;
  fills.occlude = true;
  return lines_of(read_svg_drawing(page("<g stroke='none'>" + body + "</g>"), "a.svg", {}, fills));
}

const char* const kLine = "<line y1='20' y2='20' x2='50' stroke='red'/>";
const Lines kWhole{"0,2000 5000,2000 "}, kCut{"0,2000 1000,2000 ", "3000,2000 5000,2000 "};

/// The lines but for those of the square that hides them.
Lines under(const std::string& before, const std::string& look, const std::string& behind = "") {
  Lines all = occluded(before + "<path fill='blue' d='M10 10H30V30H10Z' " + look + "/>" + behind);
  all.erase("1000,1000 3000,1000 3000,3000 1000,3000 1000,1000 ");
  return all;
}

TEST(SvgPainting, NothingIsHiddenByWhatIsSeenThrough) {
  const std::string line = kLine;
  EXPECT_EQ(under(line, ""), kCut);
  for (const char* look :
       {"style='fill:rgba(0,0,255,0.5)'", "style='fill:#00f8'", "style='fill:rgb(0 0 255 / 50%)'",
        "style='fill:hsla(240,100%,50%,.2)'", "style='mix-blend-mode:multiply'", "opacity='0.5'", "fill-opacity='0.5'"})
    EXPECT_EQ(under(line, look), kWhole) << look;
  for (const char* look : {"style='fill:rgba(0,0,255,1)'", "style='fill:#00ff'", "style='fill:rgb(0 0 255)'"})
    EXPECT_EQ(under(line, look), kCut) << look;
  const auto painted = [&](const std::string& server) { return under(server + line, "style='fill:url(#p)'"); };
  EXPECT_EQ(painted("<pattern id='p' width='4' height='4'><circle r='1'/></pattern>"), kWhole);
  EXPECT_EQ(painted("<linearGradient id='p'><stop stop-color='blue'/><stop offset='1' stop-opacity='.5'/></linearGradient>"),
            kWhole);
  EXPECT_EQ(painted("<linearGradient id='p'><stop stop-color='blue'/><stop offset='1'/></linearGradient>"), kCut);
}

TEST(SvgPainting, AGradientWithoutColoursPaintsNothing) {
  const std::string square = "<path d='M10 10H30V30H10Z' style='fill:url(#p)'/>";
  EXPECT_EQ(occluded("<linearGradient id='p'/>" + square), Lines{});
  EXPECT_EQ(occluded("<linearGradient id='q'><stop stop-color='red'/></linearGradient>"
                     "<linearGradient id='p' href='#q'/>" +
                     square)
                .size(),
            1u);
}

TEST(SvgPainting, ATranslucentGroupHidesOnlyWhatIsInIt) {
  const std::string square = "<path fill='blue' d='M10 10H30V30H10Z'/>", line = kLine;
  Lines inside = occluded("<g opacity='0.5'>" + line + square + "</g>");
  inside.erase("1000,1000 3000,1000 3000,3000 1000,3000 1000,1000 ");
  EXPECT_EQ(inside, kCut);
  Lines outside = occluded(line + "<g opacity='0.5'>" + square + "</g>");
  outside.erase("1000,1000 3000,1000 3000,3000 1000,3000 1000,1000 ");
  EXPECT_EQ(outside, kWhole);
}

TEST(SvgPainting, AnOutlineIsTheBorderOfItsArea) {
  const auto outline = [](const std::string& path) {
    return lines_of(read("<path stroke='none' fill='red' d='" + path + "'/>"));
  };
  // Two squares that overlap from 20 to 30, where one line stands for two sides.
  EXPECT_EQ(outline("M10 10H30V30H10ZM20 10H40V30H20Z"),
            (Lines{"1000,1000 3000,1000 ", "3000,1000 4000,1000 4000,3000 3000,3000 ", "3000,3000 1000,3000 1000,1000 "}));
  EXPECT_EQ(outline("M10 10H30V30H10ZM30 10H50V30H30Z"),
            (Lines{"1000,1000 3000,1000 ", "3000,1000 5000,1000 5000,3000 3000,3000 ", "3000,3000 1000,3000 1000,1000 "}))
      << "they abut";
  EXPECT_EQ(outline("M10 10H40V40H10ZM20 20V30H30V20Z").size(), 2u) << "a hole";
}

TEST(SvgPainting, AStrokedFillIsClosedWhereItIsClipped) {
  const std::string body =
      "<clipPath id='c'><rect x='20' width='80' height='100'/></clipPath>"
      "<path d='M10 10H30V30H10Z' fill='blue' stroke='red' clip-path='url(#c)'/>";
  EXPECT_EQ(lines_of(read(body)), (Lines{"2000,1000 3000,1000 3000,3000 2000,3000 ", "2000,3000 2000,1000 "}));
}

TEST(SvgPainting, PaintOrderDecidesWhatHides) {
  const auto drawn = [](const std::string& order) {
    return occluded(
        "<marker id='m' markerUnits='userSpaceOnUse' orient='0' markerWidth='9' markerHeight='9' overflow='visible'>"
        "<path d='M0 5H5' stroke='red' fill='none'/></marker>"
        "<path d='M10 10H30V30H10Z' fill='blue' stroke='green' marker-start='url(#m)' " +
        order + "/>");
  };
  EXPECT_TRUE(drawn("").contains("1000,1500 1500,1500 "));
  EXPECT_FALSE(drawn("paint-order='markers'").contains("1000,1500 1500,1500 "));
  EXPECT_FALSE(drawn("paint-order='stroke markers'").contains("1000,1500 1500,1500 "));
  EXPECT_TRUE(drawn("paint-order='fill markers'").contains("1000,1500 1500,1500 "));
}

TEST(SvgPainting, MarkersStandOnAllShapes) {
  const auto marks = [](const std::string& shape) {
    Lines all =
        lines_of(read("<marker id='m' markerUnits='userSpaceOnUse' markerWidth='9' markerHeight='9' overflow='visible'>"
                      "<path d='M0 0H1' stroke='red'/></marker><g marker-mid='url(#m)' stroke='none'>" +
                      shape + "</g>"));
    return all;
  };
  EXPECT_EQ(marks("<circle cx='50' cy='50' r='20'/>"),
            (Lines{"5000,7000 5100,7000 ", "3000,5000 3100,5000 ", "5000,3000 5100,3000 "}));
  EXPECT_EQ(marks("<rect x='10' y='10' width='20' height='30'/>"),
            (Lines{"3000,1000 3100,1000 ", "3000,4000 3100,4000 ", "1000,4000 1100,4000 "}));
}

TEST(SvgPainting, OverflowOfAMarkerMayComeFromOutside) {
  const std::string use = "<line x1='50' y1='50' x2='90' y2='50' stroke='none' marker-start='url(#m)'/>";
  const auto marker = [](const std::string& overflow) {
    return "<marker id='m' markerUnits='userSpaceOnUse' markerWidth='5' markerHeight='5' " + overflow +
           "><path d='M0 0H9' stroke='red'/></marker>";
  };
  EXPECT_EQ(lines_of(read(marker("") + use)), (Lines{"5000,5000 5500,5000 "}));
  EXPECT_EQ(lines_of(read(marker("overflow='inherit'") + use)), (Lines{"5000,5000 5900,5000 "}));
  EXPECT_EQ(lines_of(read("<g overflow='hidden'>" + marker("overflow='inherit'") + "</g>" + use)),
            (Lines{"5000,5000 5500,5000 "}));
}

TEST(SvgPainting, ADotBeginsALine) {
  EXPECT_EQ(lines_of(read("<path d='M10 10H30' stroke-linecap='round' stroke-dasharray='0 8'/>")),
            (Lines{"1000,1000 1000,1000 ", "1800,1000 1800,1000 ", "2600,1000 2600,1000 "}));
}

TEST(SvgPainting, ClipPathsAndTheirShapesAreClipped) {
  const std::string line = "<line y1='20' x2='100' y2='20' clip-path='url(#c)'/>";
  const std::string left = "<clipPath id='left'><rect x='10' width='40' height='100'/></clipPath>";
  expect_lines(left + "<clipPath id='c' clip-path='url(#left)'><rect x='30' width='40' height='100'/></clipPath>" + line,
               {"3000,2000 5000,2000 "});
  expect_lines(left +
                   "<clipPath id='c'><rect x='30' width='40' height='100' clip-path='url(#left)'/>"
                   "<rect x='80' width='10' height='100'/></clipPath>" +
                   line,
               {"3000,2000 5000,2000 ", "8000,2000 9000,2000 "}, "one shape alone");
  expect_lines(left +
                   "<defs><rect id='r' x='20' width='40' height='100' clip-path='url(#left)'/></defs>"
                   "<clipPath id='right'><rect x='30' width='70' height='100'/></clipPath>"
                   "<clipPath id='c'><use href='#r' clip-path='url(#right)'/></clipPath>" +
                   line,
               {"3000,2000 5000,2000 "}, "of a use and of what it shows");
  expect_lines(
      "<clipPath id='c' clip-path='url(#c)'><rect x='30' width='40' height='100' clip-path='url(#c)'/></clipPath>" + line,
      {"3000,2000 7000,2000 "}, "links back to itself are not followed");
}

TEST(SvgPainting, ManyShapesOfAClipPathAreClippedOneByOne) {
  std::string clip = "<clipPath id='left'><rect width='50' height='100'/></clipPath><clipPath id='c'>";
  Lines seen;
  for (int x = 0; x < 100; x += 4) {
    clip += "<rect x='" + std::to_string(x) + "' width='2' height='100' clip-path='url(#left)'/>";
    if (x < 50) seen.insert(std::to_string(100 * x) + ",2000 " + std::to_string(100 * std::min(x + 2, 50)) + ",2000 ");
  }
  expect_lines(clip + "</clipPath><line y1='20' x2='100' y2='20' clip-path='url(#c)'/>", seen);
}

TEST(SvgPainting, MasksAreMaskedAndMeasuredInBoxes) {
  const std::string line = "<line x1='0' y1='20' x2='100' y2='30' mask='url(#m)'/>";
  expect_lines(
      "<mask id='n'><rect x='10' width='40' height='100' fill='white'/></mask>"
      "<mask id='m' mask='url(#n)'><rect x='30' width='40' height='100' fill='white'/></mask>" +
          line,
      {"3000,2300 5000,2500 "});
  expect_lines(
      "<mask id='m' maskContentUnits='objectBoundingBox'><rect x='.1' width='.5' height='1' fill='white'/></mask>" + line,
      {"1000,2100 6000,2600 "});
  expect_lines(
      "<clipPath id='left'><rect x='10' width='40' height='100'/></clipPath>"
      "<mask id='m'><rect x='30' width='40' height='100' fill='white' clip-path='url(#left)'/></mask>" +
          line,
      {"3000,2300 5000,2500 "}, "a shape of the mask is clipped");
}

TEST(SvgPainting, TransparentShapesBelongToTheBox) {
  expect_lines(
      "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/></clipPath>"
      "<g clip-path='url(#c)'><rect width='100' height='100' opacity='0'/><line x1='20' y1='20' x2='90' y2='20'/></g>",
      {"2000,2000 5000,2000 "});
}

}  // namespace
}  // namespace ligne
