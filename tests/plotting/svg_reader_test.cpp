/// SVG and JSON drawings read back: drawn right, or refused by name.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <set>
#include <string>

#include <glm/geometric.hpp>

#include "plotting/drawing_reader.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/writers.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

/// In a page of 100 x 100 mm whose unit is the millimetre.
std::string page(const std::string& body, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
         "width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\" fill=\"none\" stroke=\"black\" " +
         attributes + ">\n" + body + "\n</svg>";
}

ReadDrawing read(const std::string& body) { return read_svg_drawing(page(body), "a.svg", {}); }

/// The only line of the only layer.
std::vector<Point2> line_of(const std::string& body) {
  const ReadDrawing drawing = read(body);
  if (drawing.drawing.layers.size() != 1 || drawing.drawing.layers[0].lines.size() != 1) {
    ADD_FAILURE() << body << ": not one line";
    return {{0, 0}, {0, 0}};
  }
  const auto line = drawing.drawing.layers[0].lines[0];
  return {line.begin(), line.end()};
}

void expect_points(const std::string& body, const std::vector<Point2>& wanted) {
  const std::vector<Point2> got = line_of(body);
  ASSERT_EQ(got.size(), wanted.size()) << body;
  for (std::size_t i = 0; i < got.size(); ++i)
    EXPECT_NEAR(glm::distance(got[i], wanted[i]), 0, 1e-9) << body << " point " << i;
}

double length_of(const std::string& body) {
  const std::vector<Point2> line = line_of(body);
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
  return length;
}

std::string error_of(const std::string& svg) {
  try {
    read_svg_drawing(svg, "a.svg", {});
  } catch (const std::runtime_error& e) {
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    EXPECT_LT(std::string(e.what()).size(), 400u);
    return e.what();
  }
  return "";
}

TEST(SvgReader, ShapesAreWhereTheySayTheyAre) {
  expect_points("<line x1='1' y1='2' x2='30' y2='40'/>", {{1, 2}, {30, 40}});
  expect_points("<polyline points='1,2 3 4 5-6'/>", {{1, 2}, {3, 4}, {5, -6}});
  expect_points("<polygon points='1,2 3,4 5,6'/>", {{1, 2}, {3, 4}, {5, 6}, {1, 2}});
  expect_points("<rect x='10' y='20' width='30' height='5'/>", {{10, 20}, {40, 20}, {40, 25}, {10, 25}, {10, 20}});
  expect_points("<path d='M1 2l3 4H9v-1zm0 0'/>", {{1, 2}, {4, 6}, {9, 6}, {9, 5}, {1, 2}});
  expect_points("<path d='m1 2 3 4 5 6'/>", {{1, 2}, {4, 6}, {9, 12}});
  expect_points("<path d='M.5.5.75-1e1'/>", {{0.5, 0.5}, {0.75, -10}});
}

TEST(SvgReader, CurvesAreWithinTheirFlatness) {
  for (const char* body :
       {"<circle cx='50' cy='50' r='40'/>", "<ellipse cx='50' cy='50' rx='40' ry='40'/>",
        "<path d='M90 50A40 40 0 1 1 10 50A40 40 0 0 1 90 50'/>", "<path d='M90 50a40 40 0 01-80 0 40 40 0 0180 0'/>",
        "<rect x='10' y='10' width='80' height='80' rx='40'/>"}) {
    const std::vector<Point2> line = line_of(body);
    EXPECT_GT(line.size(), 40u);
    for (std::size_t i = 0; i < line.size(); ++i) {
      EXPECT_NEAR(glm::distance(line[i], Point2(50, 50)), 40, 1e-6) << body;
      if (i > 0) {
        EXPECT_NEAR(glm::distance((line[i] + line[i - 1]) * 0.5, Point2(50, 50)), 40, 0.0051) << body;
      }
    }
  }
  // A parabola as a quadratic and as a cubic.
  for (const char* body :
       {"<path d='M0 0Q50 100 100 0'/>", "<path d='M0 0C33.3333333333 66.6666666667 66.6666666667 66.6666666667 100 0'/>",
        "<path d='M0 0q25 50 50 50t50-50'/>"}) {
    for (const Point2 p : line_of(body)) EXPECT_NEAR(p.y, 2 * p.x * (1 - p.x / 100), 1e-6) << body;
  }
  const std::vector<Point2> smooth = line_of("<path d='M0 50C0 30 20 30 20 50S40 70 40 50'/>");
  for (const Point2 p : smooth) {
    if (p.x > 20.5 && p.x < 39.5) {
      EXPECT_GT(p.y, 50) << "S mirrors the control point";
    }
  }
}

TEST(SvgReader, SmallCurvesKeepTheirLength) {
  // A Bezier curve of the third degree with these controls is a quarter of a circle but for 0.02 % of its length; the
  // quadratic one is a parabola of the length (sqrt 2 + asinh 1) / sqrt 2.
  const std::string bezier = "<path d='M50 51C50.5522847 51 51 50.5522847 51 50'/>";
  const std::string parabola = "<path d='M50 51Q51 51 51 50'/>";
  for (const double size : {0.004, 0.05, 1.0}) {
    const std::string scaled = "<g transform='scale(" + std::to_string(size) + ")'>", end = "</g>";
    const double circle = 2 * std::numbers::pi * size,
                 parabola_length = (std::sqrt(2) + std::asinh(1)) / std::sqrt(2) * size;
    EXPECT_NEAR(length_of(scaled + "<circle cx='50' cy='50' r='1'/>" + end), circle, 0.001 * circle) << size;
    EXPECT_NEAR(length_of(scaled + bezier + end), circle / 4, 0.0012 * circle / 4) << size;
    EXPECT_NEAR(length_of(scaled + parabola + end), parabola_length, 0.001 * parabola_length) << size;
  }
}

TEST(SvgReader, TransformsUnitsAndGroups) {
  expect_points("<g transform='translate(10,20)'><line x2='1' transform='rotate(90)scale(2,3)'/></g>", {{10, 20}, {10, 22}});
  expect_points("<line x2='10' transform='rotate(90 5 0)'/>", {{5, -5}, {5, 5}});
  expect_points("<line x1='1' y1='2' x2='3' y2='4' transform='matrix(1 2 3 4 5 6)'/>", {{12, 16}, {20, 28}});
  expect_points("<line y2='10' transform='skewX(45)'/>", {{0, 0}, {10, 10}});
  const auto pixels =
      read_svg_drawing("<svg width='960' height='480'><line stroke='red' x2='96' y2='1in'/></svg>", "a.svg", {});
  EXPECT_NEAR(pixels.page.width_mm, 254, 1e-9);
  EXPECT_NEAR(glm::distance(pixels.drawing.layers[0].lines[0][1], Point2(25.4, 25.4)), 0, 1e-9);
  EXPECT_EQ(pixels.drawing.layers[0].name, "#ff0000");
  const auto wide = read_svg_drawing(
      "<svg width='100mm' height='50mm' viewBox='0 0 10 10'><line stroke='red' x2='10'/></svg>", "a.svg", {});
  EXPECT_NEAR(glm::distance(wide.drawing.layers[0].lines[0][0], Point2(25, 0)), 0, 1e-9) << "xMidYMid";
}

TEST(SvgReader, APageThatTellsOneSideHasTheShapeOfItsViewBox) {
  const auto page_of = [](const std::string& sides) {
    return read_svg_drawing("<svg " + sides + " viewBox='0 0 200 100'><line stroke='red' x2='200' y2='100'/></svg>", "a.svg",
                            {});
  };
  for (const char* sides : {"height='50mm'", "width='auto' height='50mm'", "width='100mm'", "width='100mm' height='100%'"}) {
    const ReadDrawing drawing = page_of(sides);
    EXPECT_NEAR(drawing.page.width_mm, 100, 1e-9) << sides;
    EXPECT_NEAR(drawing.page.height_mm, 50, 1e-9) << sides;
    EXPECT_NEAR(glm::distance(drawing.drawing.layers[0].lines[0][1], Point2(100, 50)), 0, 1e-9) << sides;
  }
  EXPECT_NEAR(page_of("width='auto'").page.width_mm, 200 * 25.4 / 96, 1e-9);
}

TEST(SvgReader, ColoursKeepTheirNames) {
  EXPECT_EQ(read("<line x2='1' stroke='SteelBlue'/>").drawing.layers[0].name, "#4682b4");
  EXPECT_EQ(read("<line x2='1' stroke='rebeccapurple'/>").drawing.layers[0].name, "#663399");
  EXPECT_EQ(read("<line x2='1' stroke='yellowgreen'/>").drawing.layers[0].name, "#9acd32");
  EXPECT_EQ(read("<line x2='1' stroke='aliceblue'/>").drawing.layers[0].name, "#f0f8ff");
}

TEST(SvgReader, LinksLayersAndWhatDoesNotShow) {
  expect_points("<defs><line id='l' x2='5'/></defs><use xlink:href='#l' x='3' y='4'/>", {{3, 4}, {8, 4}});
  expect_points(
      "<line x2='5'/><g display='none'><line x2='9'/></g><line x2='7' stroke='none'/><line x2='8' visibility='hidden'/><line x2='4' style='stroke-opacity:0'/>",
      {{0, 0}, {5, 0}});
  const ReadDrawing layers = read(
      "<g inkscape:groupmode='layer' inkscape:label='2 fine'><g stroke='red'><line x2='1'/></g></g><line x2='2' stroke='#00f'/>");
  ASSERT_EQ(layers.drawing.layers.size(), 2u);
  EXPECT_EQ(layers.drawing.layers[0].name, "2 fine");
  EXPECT_EQ(layers.drawing.layers[1].name, "#0000ff");
  EXPECT_EQ(read("<rect width='100' height='100' fill='white' stroke='none'/><line x2='3'/>").drawing.layers.size(), 1u);
  const ReadDrawing dashed = read("<line x2='10' stroke-dasharray='2 1'/>");
  EXPECT_EQ(dashed.drawing.layers[0].lines.size(), 4u);
}

/// What the strokes of the layer take up.
Rect box_of(const ReadDrawing& drawing, const std::string& layer) {
  Rect box;
  for (const Layer& l : drawing.drawing.layers) {
    if (l.name != layer) continue;
    for (const Point2 p : l.lines.points) box.extend(p);
  }
  return box;
}
Rect text_box(const std::string& body) { return box_of(read(body), "text"); }

TEST(SvgReader, TextStandsWhereItIsWritten) {
  const Rect middle = text_box("<g font-size='10'><text x='20' y='30' text-anchor='middle'><tspan>H</tspan></text></g>");
  EXPECT_NEAR((middle.min.x + middle.max.x) / 2, 20, 0.01);
  EXPECT_NEAR(middle.max.y, 30, 1e-9);
  EXPECT_NEAR(middle.height(), 7.29, 0.01) << "capitals";
  const Rect up = text_box("<text transform='translate(5 60) rotate(-90)' font-size='10'>H</text>");
  EXPECT_NEAR(up.max.x, 5, 1e-9);
  EXPECT_NEAR(up.width(), 7.29, 0.01);
  EXPECT_LT(up.max.y, 60);
  const Rect slanted = text_box("<text transform='skewX(45)' x='0' y='10' font-size='10'>I</text>");
  EXPECT_NEAR(slanted.width(), slanted.height(), 0.01) << "no typeface is in the way of a slant";
  EXPECT_NEAR(text_box("<text x='1' y='9' style=\"font: italic 10px/1.2 'A B', serif\">H</text>").height(), 7.29, 0.01);
}

TEST(SvgReader, LettersAreMovedAndSpaced) {
  const auto text = [](const std::string& attributes, const std::string& letters) {
    return text_box("<text y='20' font-size='10' " + attributes + ">" + letters + "</text>");
  };
  const Rect plain = text("", "HH");
  EXPECT_NEAR(text("dy='0.5em'", "HH").min.y, plain.min.y + 5, 1e-9);
  EXPECT_NEAR(text("dx='3' dy='-1'", "HH").min.x, plain.min.x + 3, 1e-9);
  EXPECT_NEAR(text("letter-spacing='2'", "HH").width(), plain.width() + 2, 1e-9);
  EXPECT_NEAR(text("style='word-spacing:1em'", "H H").width(), text("", "H H").width() + 10, 1e-9);
  EXPECT_NEAR(text("", "H<tspan>H</tspan>").width(), plain.width(), 1e-9) << "one behind the other";
  EXPECT_NEAR(text("", "H<tspan><tspan dy='4'>H</tspan></tspan>").height(), plain.height() + 4, 1e-9);
  EXPECT_NEAR(text("x='5 50'", "HH").width(), 45 + text("", "H").width(), 1e-9) << "a place for each";
  EXPECT_NEAR(text("dominant-baseline='central'", "H").max.y, 20 + 3.65, 0.01);
  EXPECT_NEAR(text("rotate='90'", "I").width(), text("", "I").height(), 0.01);
  // The room of both letters, blanks at their sides included, becomes 40 mm.
  const double room = 2 * text("letter-spacing='100'", "HH").width() - 2 * text("", "H").width() - 200;
  EXPECT_NEAR(text("textLength='40'", "HH").width() - plain.width(), 40 - room, 1e-6);
  EXPECT_NEAR(text("textLength='40' lengthAdjust='spacingAndGlyphs'", "HH").width(), plain.width() * 40 / room, 1e-6);
  EXPECT_NE(error_of(page("<text><textPath href='#p'>a</textPath></text>")).find("convert the text to paths"),
            std::string::npos);
}

/// All lines of a drawing of markers M, which a line with the attributes refers to, as "x,y x,y" with two decimals; sorted.
std::vector<std::string> marks(const std::string& marker, const std::string& marked) {
  const ReadDrawing drawing = read("<marker id='m' overflow='visible' " + marker + "</marker>" + marked);
  std::vector<std::string> lines;
  for (const Layer& layer : drawing.drawing.layers) {
    for (std::size_t i = 0; i < layer.lines.size(); ++i) {
      std::string& text = lines.emplace_back();
      for (const Point2 p : layer.lines[i]) {
        char place[64];
        std::snprintf(place, sizeof place, "%s%.2f,%.2f", text.empty() ? "" : " ", p.x + 1e-9, p.y + 1e-9);
        text += place;
      }
    }
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

TEST(SvgReader, Markers) {
  using Lines = std::vector<std::string>;
  const std::string stroke = "><path stroke='red' d='M0 0h1'/>";
  EXPECT_EQ(marks(stroke, "<path stroke-width='2' d='M10 10h20v20' marker-end='url(#m)'/>"),
            (Lines{"10.00,10.00 30.00,10.00 30.00,30.00", "30.00,30.00 32.00,30.00"}))
      << "in widths of the stroke, not turned";
  EXPECT_EQ(marks("orient='auto' markerUnits='userSpaceOnUse' refX='1'" + stroke,
                  "<path stroke='none' stroke-width='2' d='M10 10h20v20' marker-end='url(#m)'/>"),
            (Lines{"30.00,29.00 30.00,30.00"}))
      << "without a stroke too";
  EXPECT_EQ(marks("orient='auto'" + stroke, "<path stroke='none' d='M10 10h20v20h20' style='marker-mid:url(#m)'/>"),
            (Lines{"30.00,10.00 30.71,10.71", "30.00,30.00 30.71,30.71"}))
      << "half way between both sides";
  EXPECT_EQ(
      marks("orient='auto-start-reverse'" + stroke, "<g style='marker:url(#m)' stroke='none'><line x1='10' x2='20'/></g>"),
      (Lines{"10.00,0.00 9.00,0.00", "20.00,0.00 21.00,0.00"}))
      << "inherited";
  EXPECT_EQ(marks("orient='90'" + stroke, "<g stroke='none' style='marker:url(#m)'><line x2='9' marker-start='none'/></g>"),
            (Lines{"9.00,0.00 9.00,1.00"}));
  EXPECT_EQ(marks("orient='auto'" + stroke, "<path stroke='none' d='M10 10C10 5 20 5 20 10' marker-end='url(#m)'/>"),
            (Lines{"20.00,10.00 20.00,11.00"}))
      << "along the curve, not along a chord";
  EXPECT_EQ(marks("orient='auto'" + stroke, "<path stroke='none' d='M10 10A10 10 0 0 1 20 20' marker-start='url(#m)'/>"),
            (Lines{"10.00,10.00 11.00,10.00"}));
  EXPECT_EQ(marks("orient='auto'" + stroke, "<path stroke='none' d='M10 10h10v10z' marker-start='url(#m)'/>").size(), 1u);
  EXPECT_EQ(marks("viewBox='0 0 10 10' refX='10' refY='5' markerWidth='4' markerHeight='4'><path stroke='red' d='M0 5h10'/>",
                  "<line x1='50' x2='60' y1='50' y2='50' stroke='none' marker-end='url(#m)'/>"),
            (Lines{"56.00,50.00 60.00,50.00"}));
  EXPECT_TRUE(
      marks("><path d='M0 0h1' stroke='context-stroke'/>", "<line x2='9' stroke='none' marker-end='url(#m)'/>").empty());
  EXPECT_EQ(marks("><path d='M0 0h1' stroke='context-stroke'/>", "<line x2='9' marker-end='url(#m)'/>").size(), 2u);
  EXPECT_EQ(marks(stroke, "<line x2='9' marker='url(#m)'/>").size(), 1u) << "a property, no attribute";
  EXPECT_EQ(read("<line x2='5' marker-end='url(#none)'/>").drawing.layers.size(), 1u) << "as viewers do";
  const ReadDrawing clipped = read(
      "<marker id='m'><path d='M-5 1h20' stroke='red'/></marker><line x2='9' y1='9' y2='9' stroke='none' marker-end='url(#m)'/>");
  ASSERT_EQ(clipped.drawing.layers.size(), 1u);
  EXPECT_NEAR(clipped.drawing.layers[0].lines[0].back().x, 12, 1e-9) << "three wide, if nothing is said";
}

TEST(SvgReader, RefusesByName) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"<image href='a.png'/>", "<image> has image"},
      {"<g clip-path='circle(5px)'><line x2='5'/></g>", "<g> has clip-path"},
      {"<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='1' height='1'/></clipPath> <g clip-path='url(#c)'/>",
       "<g> has clip-path"},
      {"<clipPath id='c'><text>a</text></clipPath> <line x2='5' clip-path='url(#c)'/>", "<text> has clip-path"},
      {"<mask id='m'><image/></mask> <line x2='5' style='mask:url(#m)'/>", "<image> has mask"},
      {"<marker id='m'><path d='M0 0h1' marker-end='url(#m)'/></marker><line x2='5' marker-end='url(#m)'/>",
       "has markers that lead on"},
      {"<style>@media print{line{stroke:none}}</style>", "<style> has style"},
      {"<style>line:first-child{stroke:none}</style>", "<style> has style"},
      {"<style>line{transform:none}</style>\n<line x2='5'/>", "<line> has "},
      {"<foreignObject/>", "has foreignObject"},
      {"<text><textPath href='#p'>a</textPath></text>", "has text"},
      {"<line x2='5'><animate/></line><animate/>", "has animation"},
      {"<line x2='5' stroke='?'/>", "is not a colour"},
      {"<line x2='5furlongs'/>", "is not a length"},
      {"<path d='L1 2'/>", "do not begin with M"},
      {"<path d='M1 2X3'/>", "unknown command"},
      {"<path d='M1 2L3'/>", "number"},
      {"<polyline points='1 2 3'/>", "odd number"},
      {"<g transform='spin(3)'/>", "transforms"},
      {"<line x2='5' transform='rotate(45)' transform-origin='5 5'/>", "<line> has style"},
      {"<line x2='1e300' transform='scale(1e300)'/>", "kilometre"},
      {"<line x2='nan'/>", "number"},
      {"<use xlink:href='other.svg#a'/>", "leads out of the file"},
      {"<g id='a'><use xlink:href='#a'/></g>", "leads on more than"},
      {"<clipPath id='c'><use id='u' xlink:href='#u'/></clipPath><line x2='5' clip-path='url(#c)'/>", "has clip-path"},
      {"<symbol id='a' viewBox='0 0 1'><line x2='1'/></symbol><use xlink:href='#a'/>", "viewBox"},
  };
  for (const auto& [body, wanted] : cases) {
    const std::string error = error_of(page(body));
    EXPECT_NE(error.find(wanted), std::string::npos) << body << ": " << error;
    EXPECT_TRUE(error.starts_with("a.svg:2: ") || error.starts_with("a.svg:3: ")) << error;
  }
  EXPECT_NE(error_of("<svg").find("is not XML"), std::string::npos);
  EXPECT_NE(error_of("<html/>").find("is not an SVG"), std::string::npos);
  EXPECT_NE(error_of("").find("is not XML"), std::string::npos);
}

/// All lines of all layers, as texts of whole hundredths, sorted.
std::multiset<std::string> lines_of(const ReadDrawing& drawing) {
  std::multiset<std::string> all;
  for (const Layer& layer : drawing.drawing.layers) {
    for (std::size_t i = 0; i < layer.lines.size(); ++i) {
      std::string text;
      for (const Point2 p : layer.lines[i])
        text += std::to_string(std::lround(p.x * 100)) + "," + std::to_string(std::lround(p.y * 100)) + " ";
      all.insert(text);
    }
  }
  return all;
}

using Lines = std::multiset<std::string>;

TEST(SvgReader, ClipPathsCutWhatTheyHide) {
  const std::string box = "<defs><clipPath id='c'><rect x='10' y='10' width='20' height='20'/></clipPath></defs>";
  EXPECT_EQ(lines_of(read(box + "<line y1='20' x2='100' y2='20' clip-path='url(#c)'/>")), Lines{"1000,2000 3000,2000 "});
  EXPECT_EQ(lines_of(read(box + "<g clip-path=\"url('#c')\"><polyline points='0,20 20,20 20,0 25,0 25,50'/></g>")),
            (Lines{"1000,2000 2000,2000 2000,1000 ", "2500,1000 2500,3000 "}));
  EXPECT_EQ(
      lines_of(read(box + "<g transform='translate(50 0)'><line y1='20' x2='100' y2='20' style='clip-path: url(#c)'/></g>")),
      Lines{"6000,2000 8000,2000 "})
      << "in the units of the element that is cut";
  EXPECT_EQ(
      lines_of(read(
          box +
          "<g clip-path='url(#c)'><g transform='translate(10 0)'><line y1='20' x2='100' y2='20' clip-path='url(#c)'/></g></g>")),
      Lines{"2000,2000 3000,2000 "})
      << "one inside the other";
  EXPECT_EQ(lines_of(read(box + "<line x1='10' y1='5' x2='10' y2='50' clip-path='url(#c)'/>")),
            Lines{"1000,1000 1000,3000 "})
      << "half of its width shows";
  EXPECT_EQ(lines_of(read("<clipPath id='c'/><line x2='9' clip-path='url(#c)'/>")), Lines{})
      << "nothing shows through an empty one";
  EXPECT_EQ(lines_of(read("<line x2='9' clip-path='url(#none)'/>")), Lines{"0,0 900,0 "});
}

TEST(SvgReader, ClipPathsOfAnyShape) {
  // Two squares, wound alike, that overlap from 20 to 30.
  const std::string path = "<path d='M10 10h20v20h-20zM20 10h20v20h-20z' ";
  const std::string line = "<line y1='20' x2='100' y2='20' clip-path='url(#c)'/>";
  EXPECT_EQ(lines_of(read("<clipPath id='c'>" + path + "/></clipPath>" + line)), Lines{"1000,2000 4000,2000 "});
  EXPECT_EQ(lines_of(read("<clipPath id='c'>" + path + "clip-rule='evenodd'/></clipPath>" + line)),
            (Lines{"1000,2000 2000,2000 ", "3000,2000 4000,2000 "}));
  EXPECT_EQ(
      lines_of(read(
          "<clipPath id='c'><rect x='10' width='5' height='50'/><rect x='12' width='8' height='50'/><use xlink:href='#r' x='30'/></clipPath>"
          "<defs><rect id='r' width='3' height='50'/></defs>" +
          line)),
      (Lines{"1000,2000 2000,2000 ", "3000,2000 3300,2000 "}));
  const ReadDrawing round = read(
      "<clipPath id='c'><circle cx='50' cy='50' r='30'/></clipPath><g clip-path='url(#c)'><path d='M0 50H100M50 0V100M0 0L100 100'/></g>");
  for (const Point2 p : round.drawing.layers.at(0).lines.points) EXPECT_NEAR(glm::distance(p, Point2(50, 50)), 30, 0.006);
  // A hundred thousand random segments: what is kept is inside, what is not is outside, and nothing is lost at corners.
  std::string star = "M", crowd;
  std::vector<Point2> corners;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 ? 15 : 40, a = i * std::numbers::pi / 5;
    corners.push_back({50 + r * std::cos(a), 50 + r * std::sin(a)});
    star += std::to_string(corners.back().x) + " " + std::to_string(corners.back().y) + (i < 9 ? "L" : "Z");
  }
  for (int i = 0; i < 100; ++i) crowd += "M0 " + std::to_string(i + 0.5) + "H100";
  const ReadDrawing stripes =
      read("<clipPath id='c'><path d='" + star + "'/></clipPath><path clip-path='url(#c)' d='" + crowd + "'/>");
  double length = 0, area = 0;
  const Polylines& kept = stripes.drawing.layers.at(0).lines;
  for (std::size_t i = 0; i < kept.size(); ++i) length += glm::distance(kept[i].front(), kept[i].back());
  for (std::size_t i = 0; i < 10; ++i)
    area += (corners[i].x * corners[(i + 1) % 10].y - corners[i].y * corners[(i + 1) % 10].x) / 2;
  EXPECT_NEAR(length, area, 0.01 * area) << "stripes one millimetre apart";
}

TEST(SvgReader, MasksOfShapesAndClipPathsInUnitsOfABox) {
  EXPECT_EQ(
      lines_of(read(
          "<mask id='m'><rect width='50' height='50' fill='white'/><rect x='10' width='10' height='50' fill='black'/></mask>"
          "<line y1='20' x2='100' y2='20' mask='url(#m)'/>")),
      (Lines{"0,2000 1000,2000 ", "2000,2000 5000,2000 "}))
      << "the last one painted decides";
  EXPECT_EQ(lines_of(read("<line y1='20' x2='100' y2='20' mask='url(#none)'/>")), Lines{"0,2000 10000,2000 "});
  EXPECT_EQ(
      lines_of(read("<clipPath id='c' clipPathUnits='objectBoundingBox'><rect x='0.25' width='0.5' height='1'/></clipPath>"
                    "<polyline points='10,10 30,10 50,30' clip-path='url(#c)'/>")),
      Lines{"2000,1000 3000,1000 4000,2000 "});
}

TEST(SvgReader, StyleSheets) {
  EXPECT_EQ(
      lines_of(read("<style>line[id]{stroke:none} [x2='2']{stroke:none} line[class~=b]{stroke:none} "
                    "line[class^=\"pre\"]{stroke:none} line[class$=fix]{stroke:none} line[class*=mid]{stroke:none}</style>"
                    "<line id='a' x2='1'/><line x2='2'/><line class='a b' x2='3'/><line class='prefer' x2='4'/>"
                    "<line class='suffix' x2='5'/><line class='amidst' x2='6'/><line class='c' x2='7'/>")),
      Lines{"0,0 700,0 "});
  EXPECT_EQ(
      lines_of(read(
          "<style>.no{stroke:none} #seen{stroke:red} g.in > line{display:none} g path { stroke-dasharray: 2 1 } *{stroke-linejoin:round}</style>"
          "<line class='a no b' x2='1'/><line class='no' id='seen' x2='2'/><g class='in'><line x2='3'/><g><line x2='4'/></g></g><g><path d='M0 9h4'/></g>")),
      (Lines{"0,0 200,0 ", "0,0 400,0 ", "0,900 200,900 ", "300,900 400,900 "}));
  const ReadDrawing colors = read(
      "<style type='text/css'><![CDATA[ /* black */ line, polyline.x { stroke: blue } line { stroke: #00ff00 !important; } ]]></style>"
      "<line x2='1' style='stroke:red'/><polyline class='x' points='0 1 2 1' stroke='red'/><polyline class='x' points='0 2 2 2' style='stroke:red'/>");
  ASSERT_EQ(colors.drawing.layers.size(), 3u);
  EXPECT_EQ(colors.drawing.layers[0].name, "#00ff00") << "!important";
  EXPECT_EQ(colors.drawing.layers[1].name, "#0000ff") << "a rule goes before an attribute";
  EXPECT_EQ(colors.drawing.layers[2].name, "#ff0000") << "and behind the style attribute";
  EXPECT_EQ(
      lines_of(read("<style>@font-face{font-family:x;src:none} a:hover{stroke:none} <!-- --></style><line x2='1'/>")).size(),
      1u);
  EXPECT_EQ(lines_of(read("<style>g{display:none}</style><g style='display:inline'><line x2='1'/></g>")).size(), 1u);
  std::string many = "<style>";
  for (int i = 0; i < 9000; ++i) many += "g g g line{stroke:red}";
  std::string nest, crowd;
  for (int i = 0; i < 100; ++i) nest += "<g>", crowd += "</g>";
  for (int i = 0; i < 2000; ++i) nest += "<line x2='1'/>";
  EXPECT_NE(error_of(page(many + "</style>" + nest + crowd)).find("endless work"), std::string::npos);
}

TEST(SvgReader, SymbolsAndNestedDrawings) {
  EXPECT_EQ(lines_of(read(
                "<svg x='10' y='20' width='30' height='30' viewBox='0 0 3 3'><line x1='-1' y1='1' x2='2' y2='1'/></svg>")),
            Lines{"1000,3000 3000,3000 "})
      << "scaled, and cut at its frame";
  EXPECT_EQ(
      lines_of(read(
          "<svg x='10' y='20' width='30' height='30' viewBox='0 0 3 3' overflow='visible'><line x1='-1' y1='1' x2='2' y2='1'/></svg>")),
      Lines{"0,3000 3000,3000 "});
  EXPECT_EQ(lines_of(read("<svg width='50%' height='10'><line x2='100%'/></svg>")), Lines{"0,0 5000,0 "});
  const std::string symbol = "<symbol id='s' viewBox='0 0 10 10'><line x2='10' y2='10'/></symbol>";
  EXPECT_EQ(lines_of(read(symbol + "<use xlink:href='#s' x='5' y='6' width='20' height='20'/>")),
            Lines{"500,600 2500,2600 "});
  EXPECT_EQ(lines_of(read(symbol + "<use href='#s' x='5' width='0' height='20'/>")), Lines{});
  EXPECT_EQ(lines_of(read("<symbol id='r' viewBox='0 0 10 10' refX='5' refY='10'><line x2='10' y2='10'/></symbol>"
                          "<use href='#r' x='50' y='60' width='20' height='20'/>")),
            Lines{"4000,4000 6000,6000 "});
  EXPECT_EQ(
      lines_of(read("<symbol id='g' overflow='visible'><path d='M1 1L-4 1'/></symbol><use xlink:href='#g' x='50' y='50'/>")),
      Lines{"5100,5100 4600,5100 "});
}

TEST(SvgReader, RealFilesGoIn) {
  const ReadDrawing notes = read("<WCB><path d='M0 0H9'/></WCB><plotdata/><plotdata/><line x2='5' font-size='medium'/>");
  EXPECT_EQ(lines_of(notes), Lines{"0,0 500,0 "}) << "nothing in an element that SVG does not know is shown";
  EXPECT_EQ(notes.unknown.at("<WCB>"), 1u);
  EXPECT_EQ(notes.unknown.at("<plotdata>"), 2u);
  EXPECT_EQ(lines_of(read("<switch><foreignObject/><g requiredExtensions='x'><line x2='1'/></g><g systemLanguage='fr'>"
                          "<line x2='2'/></g><g><line x2='3'/></g><line x2='4'/></switch>")),
            Lines{"0,0 300,0 "})
      << "the first that is for everybody";
  EXPECT_EQ(lines_of(read("<line x2='5' stroke-opacity='null' stroke-dasharray='null'/>")).size(), 1u);
  const ReadDrawing gradient = read(
      "<defs><linearGradient id='a'><stop stop-color='white'/><stop style='stop-color:#00ff00'/></linearGradient><linearGradient id='b' href='#a'/></defs>"
      "<line x2='5' stroke='url(#b)'/><line x2='6' stroke='url(#none) red'/><line x2='7' filter='url(#f)'/>");
  ASSERT_EQ(gradient.drawing.layers.size(), 3u);
  EXPECT_EQ(gradient.drawing.layers[0].name, "#00ff00") << "its first colour that is seen on paper";
  EXPECT_EQ(gradient.drawing.layers[1].name, "#ff0000");
  EXPECT_EQ(gradient.simplified_paints, 2u);
  EXPECT_EQ(gradient.filters, 1u);
  EXPECT_EQ(read("<line x2='5' stroke='hsl(120, 100%, 25%)'/>").drawing.layers.at(0).name, "#008000");
  EXPECT_EQ(read("<line x2='5' stroke='hsla(-120deg 100% 50% / 0.5)'/>").drawing.layers.at(0).name, "#0000ff");
  EXPECT_EQ(read("<line x2='5' stroke='#ff000080'/>").drawing.layers.at(0).name, "#ff0000");
  EXPECT_EQ(read("<line x2='5' stroke='#f000'/>").drawing.layers.size(), 0u) << "clear";
  const ReadDrawing unsized = read_svg_drawing("<svg><line stroke='red' x2='96'/></svg>", "a.svg", {});
  EXPECT_TRUE(unsized.size_assumed);
  EXPECT_NEAR(unsized.page.width_mm, 1000 * 25.4 / 96, 1e-9);
}

TEST(SvgReader, StrokesKeepTheirColoursAndWidths) {
  const ReadDrawing drawing = read(
      "<g inkscape:groupmode='layer' inkscape:label='3 red'><line x2='1' stroke='red' stroke-width='2'/>"
      "<line x2='2' stroke='#00f' transform='scale(0.5)' stroke-width='2'/><line x2='3' stroke='red' stroke-width='2'/></g>"
      "<line x2='4' stroke='red' vector-effect='non-scaling-stroke' stroke-width='96' transform='scale(3)'/>");
  ASSERT_EQ(drawing.drawing.layers.size(), 3u);
  const std::vector<Layer>& layers = drawing.drawing.layers;
  EXPECT_EQ(layers[0].name, "3 red");
  EXPECT_EQ(layers[0].lines.size(), 2u);
  EXPECT_EQ(layers[0].color, (std::array<double, 3>{1, 0, 0}));
  EXPECT_NEAR(layers[0].width_mm.value(), 2, 1e-9);
  EXPECT_EQ(layers[1].name, "3 red");
  EXPECT_EQ(layers[1].color, (std::array<double, 3>{0, 0, 1}));
  EXPECT_NEAR(layers[1].width_mm.value(), 1, 1e-9) << "as wide as it is on the page";
  EXPECT_NEAR(layers[2].width_mm.value(), 25.4, 1e-9) << "whatever the transforms";
}

TEST(SvgReader, WhiteAreasAreLaidOverWhatIsUnderThem) {
  const std::string line = "<line y1='20' x2='100' y2='20'/>";
  EXPECT_EQ(lines_of(read(line + "<rect x='10' y='10' width='20' height='20' fill='white' stroke='none'/>")),
            (Lines{"0,2000 1000,2000 ", "3000,2000 10000,2000 "}));
  EXPECT_EQ(lines_of(read("<rect x='10' y='10' width='20' height='20' fill='white' stroke='none'/>" + line)),
            Lines{"0,2000 10000,2000 "})
      << "below is paper";
  EXPECT_EQ(lines_of(read(line + "<rect x='10' y='20' width='20' height='20' fill='white' stroke='none'/>")),
            Lines{"0,2000 10000,2000 "})
      << "a line on the rim is seen";
  EXPECT_EQ(
      lines_of(read(line + "<path d='M10 10h40v20h-40zM20 15h20v10h-20z' fill='white' fill-rule='evenodd' stroke='none'/>")),
      (Lines{"0,2000 1000,2000 ", "2000,2000 4000,2000 ", "5000,2000 10000,2000 "}))
      << "through a hole";
  EXPECT_EQ(
      lines_of(read(line + "<rect x='10' y='10' width='20' height='20' fill='white' fill-opacity='0.5' stroke='none'/>")),
      Lines{"0,2000 10000,2000 "})
      << "one shines through";
  EXPECT_EQ(lines_of(read("<clipPath id='c'><rect x='15' width='100' height='100'/></clipPath>" + line +
                          "<rect clip-path='url(#c)' x='10' y='10' width='20' height='20' fill='white' stroke='none'/>")),
            (Lines{"0,2000 1500,2000 ", "3000,2000 10000,2000 "}))
      << "only what is seen hides";
}

TEST(SvgReader, AreasHideOnlyTheirLayerWhenAsked) {
  const auto layer = [](const char* name, const char* body) {
    return std::string("<g inkscape:groupmode='layer' inkscape:label='") + name + "'>" + body + "</g>";
  };
  const std::string body = page(layer("a",
                                      "<line y1='20' x2='100' y2='20'/>"
                                      "<rect x='10' y='10' width='20' height='20' fill='red' stroke='none'/>") +
                                layer("b", "<rect x='50' y='10' width='20' height='20' fill='white' stroke='none'/>"));
  const ReadDrawing across = read_svg_drawing(body, "a.svg", {}, {FillReading::How::outline, 0.35, true}),
                    within = read_svg_drawing(body, "a.svg", {}, {FillReading::How::outline, 0.35, true, true});
  EXPECT_EQ(lines_of(across).count("3000,2000 5000,2000 "), 1u);
  EXPECT_EQ(lines_of(within).count("0,2000 1000,2000 "), 1u);
  EXPECT_EQ(lines_of(within).count("3000,2000 10000,2000 "), 1u) << "what another layer holds is not hidden";
}

TEST(SvgReader, OpaqueAreasHideWhenAsked) {
  const std::string body = page(
      "<line y1='20' x2='100' y2='20'/><rect x='10' y='10' width='20' height='20' fill='red'/>"
      "<g inkscape:groupmode='layer' inkscape:label='% note'><rect x='50' y='10' width='20' height='20' fill='red' stroke='none'/></g>"
      "<text x='60' y='25' font-size='20'>I</text><circle cx='62' cy='20' r='12' fill='blue'/>");
  const ReadDrawing plain = read_svg_drawing(body, "a.svg", {}),
                    occluded = read_svg_drawing(body, "a.svg", {}, {FillReading::How::outline, 0.35, true});
  EXPECT_EQ(lines_of(plain).count("0,2000 10000,2000 "), 1u);
  EXPECT_EQ(lines_of(occluded).count("0,2000 1000,2000 "), 1u);
  EXPECT_EQ(lines_of(occluded).count("3000,2000 5000,2000 "), 1u) << "a layer that is not plotted hides nothing";
  EXPECT_EQ(lines_of(occluded).count("7400,2000 10000,2000 "), 1u);
  EXPECT_TRUE(box_of(occluded, "text").empty()) << "the letter is under the disc";
  EXPECT_FALSE(box_of(plain, "text").empty());
}

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
    for (const Layer& layer : read.drawing.layers) {
      if (layer.name == std::to_string(i + 1)) length += measure(layer.lines, {0, 0}, false).down_mm;
    }
    EXPECT_NEAR(length, expected, 0.1) << i;
  }
}

TEST(SvgReader, DotsAndFills) {
  EXPECT_EQ(lines_of(read("<path d='M5 5h0' stroke-linecap='round'/>")), Lines{"500,500 500,500 "});
  EXPECT_EQ(lines_of(read("<path d='M5 5h0'/>")), Lines{}) << "butt ends";
  Drawing dots;
  add_line(dots, "outline", {{5, 5}, {5, 5}});
  EXPECT_EQ(lines_of(read_svg_drawing(write_svg(dots, {}), "a.svg", {})), Lines{"500,500 500,500 "}) << "ours come back";
  const std::string square =
      page("<path d='M10 10h20v20h-20zM15 15h10v10h-10z' fill='red' stroke='none'/><text x='1' y='9'>a</text>");
  const auto with = [&](FillReading::How how) { return read_svg_drawing(square, "a.svg", {}, {how, 0.5}); };
  EXPECT_EQ(with(FillReading::How::outline).drawing.layers.at(0).lines.size(), 2u);
  EXPECT_GT(measure(with(FillReading::How::hatch).drawing.layers.at(0).lines, {0, 0}, false).down_mm, 400 / 0.4 * 0.9)
      << "wound alike: no hole";
  EXPECT_EQ(read_svg_drawing(square, "a.svg", {}).outlined, 1u) << "and it is said";
  EXPECT_THROW(with(FillReading::How::refuse), std::runtime_error);
}

Lines lines_without_text(ReadDrawing drawing) {
  std::erase_if(drawing.drawing.layers, [](const Layer& layer) { return layer.name == "text"; });
  return lines_of(drawing);
}

ReadDrawing read_file(const char* name) {
  std::ifstream in(std::string(LIGNE_SOURCE_DIR "/tests/plotting/drawings/") + name);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return read_svg_drawing(text, name, {});
}

/// In the manner of other programs: a point is 25.4 / 72 mm, a pixel 25.4 / 96.
TEST(SvgReader, DrawingsOfOtherPrograms) {
  const ReadDrawing matplotlib = read_file("matplotlib.svg");
  EXPECT_NEAR(matplotlib.page.width_mm, 50.8, 1e-9);
  EXPECT_EQ(lines_without_text(matplotlib),
            (Lines{"1270,1270 2117,423 ", "3810,423 4657,1270 ", "1270,2117 1270,2240 ", "1270,2117 1270,423 "}));
  EXPECT_GE(box_of(matplotlib, "text").height(), 10 * 25.4 / 72 * 0.729 - 0.001);
  const ReadDrawing gnuplot = read_file("gnuplot.svg");
  EXPECT_NEAR(gnuplot.page.width_mm, 50.8, 1e-9);
  EXPECT_EQ(lines_without_text(gnuplot),
            (Lines{"1270,1905 1508,1905 ", "3810,1905 3572,1905 ", "1270,635 2540,1270 3810,635 ", "2421,635 2659,635 ",
                   "2540,516 2540,754 "}));
  ASSERT_EQ(gnuplot.drawing.layers.size(), 4u);
  EXPECT_EQ(gnuplot.drawing.layers[3].name, "#009e73") << "the colour of the use";
  const ReadDrawing svglite = read_file("svglite.svg");
  EXPECT_EQ(lines_without_text(svglite), (Lines{"1270,2117 3810,2117 ", "1270,1270 2540,1270 2540,2117 "}));
  EXPECT_EQ(svglite.drawing.layers.at(1).name, "#df536b");
}

TEST(SvgReader, TextShowsThroughClipPathsInPart) {
  const std::string text = "<text x='10' y='20' font-size='10' clip-path='url(#c)'>HHHH</text>";
  EXPECT_NEAR(text_box("<clipPath id='c'><rect width='100' height='100'/></clipPath>" + text).max.y, 20, 1e-9);
  const Rect half = text_box("<clipPath id='c'><rect width='100' height='16'/></clipPath>" + text);
  EXPECT_NEAR(half.max.y, 16, 1e-9);
  EXPECT_LT(half.min.y, 16);
}

TEST(SvgReader, LeavesOutWhatMayBeLeftOut) {
  const ReadDrawing drawing =
      read_svg_drawing(page("<image/><image/><path d='M0 0L9 0 9 9z' fill='red'/>"), "a.svg", {"image", "fill"});
  EXPECT_EQ(drawing.left_out.at("image"), 2u);
  EXPECT_EQ(drawing.left_out.at("fill"), 1u);
  EXPECT_EQ(drawing.drawing.layers.at(0).lines.size(), 1u);
}

TEST(SvgReader, BombsDoNoHarm) {
  const auto start = std::chrono::steady_clock::now();
  std::string entities = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\">";
  for (char c = 'b'; c < 'z'; ++c)
    entities += std::string("<!ENTITY ") + c + " \"" + std::string(10, '&') + static_cast<char>(c - 1) + ";\">";
  EXPECT_NE(error_of(entities + "]>" + page("<text>&y;</text>")).find("entity"), std::string::npos);
  EXPECT_NE(error_of(entities + "]>" + page("<line x2='&y;'/>")), "");

  std::string links = "<g id='a0'><line x2='1'/></g>";
  for (int i = 1; i < 12; ++i) {
    links += "<g id='a" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) links += "<use xlink:href='#a" + std::to_string(i - 1) + "'/>";
    links += "</g>";
  }
  EXPECT_NE(error_of(page(links)), "");

  // Clip paths and fills of many edges from top to bottom, and many lines through them.
  std::string comb = "M0 0", across;
  for (int i = 0; i < 50'000; ++i) comb += "L" + std::to_string(i * 0.002) + (i % 2 ? " 0" : " 100");
  for (int i = 0; i < 50'000; ++i) across += "M0 " + std::to_string(i * 0.002) + "H100";
  EXPECT_NE(
      error_of(page("<clipPath id='c'><path d='" + comb + "z'/></clipPath><path clip-path='url(#c)' d='" + across + "'/>"))
          .find("endless work"),
      std::string::npos);
  std::string areas;
  for (int i = 0; i < 5'000; ++i) areas += "<path d='M0 0H1000000V1000000H0z' fill='red' stroke='none'/>";
  EXPECT_THROW(read_svg_drawing(page(areas), "a.svg", {}, {FillReading::How::hatch, 0.01}), std::runtime_error);

  std::string deep, ends;
  for (int i = 0; i < 100'000; ++i) deep += "<g>", ends += "</g>";
  EXPECT_NE(error_of(page(deep + ends)).find("nested deeper"), std::string::npos);
  EXPECT_NE(error_of(page("<line x2='" + std::string(30'000'000, '1') + "'/>")), "");
  EXPECT_NE(error_of(page("<path d='" + std::string(30'000'000, 'z') + "'/>")), "");
  EXPECT_EQ(error_of(page("<line x2='1' data-x='" + std::string(30'000'000, 'z') + "'/>")), "");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST(SvgReader, OurOwnDrawingsComeBackAsTheyWere) {
  Drawing drawing = sample_drawing();
  drawing.layers.erase(drawing.layers.begin());  // its dashes come back as strokes
  const ReadDrawing back = read_svg_drawing(write_svg(drawing, {}), "a.svg", {});
  EXPECT_NEAR(back.page.width_mm, 210, 1e-9);
  ASSERT_EQ(back.drawing.layers.size(), drawing.layers.size());
  for (std::size_t l = 0; l < drawing.layers.size(); ++l) {
    EXPECT_EQ(back.drawing.layers[l].name, drawing.layers[l].name);
    const Polylines &was = drawing.layers[l].lines, &is = back.drawing.layers[l].lines;
    ASSERT_EQ(is.begin, was.begin);
    for (std::size_t i = 0; i < was.points.size(); ++i) EXPECT_NEAR(glm::distance(is.points[i], was.points[i]), 0, 1e-4);
  }
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

TEST(JsonDrawingReader, RefusesWhatIsWrong) {
  const std::string head =
      "{\"format\":\"ligne-drawing\",\"version\":2,\"page\":{\"width_mm\":210,\"height_mm\":297,\"margin_mm\":10},";
  const std::string stroke = "{\"class\":\"outline\",\"visible\":true,\"points\":[[1,2],[3,4]]}";
  EXPECT_EQ(read_json_drawing(head + "\"strokes\":[" + stroke + "]}", "a.json").drawing.layers.size(), 1u);
  const std::string version_1 = "{\"format\":\"ligne-drawing\",\"version\":1," + head.substr(head.find("\"page\""));
  EXPECT_EQ(read_json_drawing(version_1 + "\"strokes\":[" + stroke + "]}", "a.json").drawing.layers.size(), 1u);
  std::string deep(200'000, '[');
  for (const std::string& wrong :
       {std::string("{"), std::string("[]"), std::string("{}"), head + "\"order\":[]}", head + "\"strokes\":[{}]}",
        head + "\"strokes\":[{\"class\":\"ink\",\"visible\":true,\"points\":[[1,2],[3,4]]}]}",
        head + "\"strokes\":[{\"class\":\"mesh\",\"visible\":1,\"points\":[[1,2],[3,4]]}]}",
        head + "\"strokes\":[{\"class\":\"mesh\",\"visible\":true,\"points\":[[1,2]]}]}",
        head + "\"strokes\":[{\"class\":\"mesh\",\"visible\":true,\"points\":[[1,2],[3,1e9]]}]}",
        head + "\"strokes\":[],\"strokes\":[]}", std::string("{\"format\":\"ligne-drawing\",\"version\":3,\"strokes\":[]}"),
        deep, std::string("{\"format\":\"ligne-drawing\",\"version\":1,\"page\":{\"width_mm\":0},\"strokes\":[]}")}) {
    EXPECT_THROW(read_json_drawing(wrong, "a.json"), std::runtime_error) << wrong.substr(0, 200);
  }
}

}  // namespace
}  // namespace ligne
