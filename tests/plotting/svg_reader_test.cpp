/// SVG drawings read back: drawn right, or refused by name.

#include "plotting/paths/optimize.hpp"
#include "plotting/writers/writers.hpp"
#include "sample_drawing.hpp"
#include "support/test.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

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
      {"<style>@media screen{line{stroke:none}}</style>", "<style> has style"},
      {"<style>line:link{stroke:none}</style>", "<style> has style"},
      {"<style>line{transform:spin(3deg)}</style>\n<line x2='5'/>", "<line> transform: "},
      {"<foreignObject/>", "has foreignObject"},
      {"<text><textPath href='#p'>a</textPath></text>", "has text"},
      {"<line x2='5'><animate/></line><animate/>", "has animation"},
      {"<line x2='5' stroke='?'/>", "is not a known colour"},
      {"<line x2='5furlongs'/>", "is not a length"},
      {"<path d='L1 2'/>", "do not begin with M"},
      {"<path d='M1 2X3'/>", "unknown command"},
      {"<path d='M1 2L3'/>", "number"},
      {"<polyline points='1 2 3'/>", "odd number"},
      {"<g transform='spin(3)'/>", "transforms"},
      {"<line x2='5' transform='rotate(45)' transform-origin='5 x'/>", "<line> transform-origin: "},
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

TEST(SvgReader, StyleSheets) {
  expect_lines(
      "<style>line[id]{stroke:none} [x2='2']{stroke:none} line[class~=b]{stroke:none} "
      "line[class^=\"pre\"]{stroke:none} line[class$=fix]{stroke:none} line[class*=mid]{stroke:none}</style>"
      "<line id='a' x2='1'/><line x2='2'/><line class='a b' x2='3'/><line class='prefer' x2='4'/>"
      "<line class='suffix' x2='5'/><line class='amidst' x2='6'/><line class='c' x2='7'/>",
      {"0,0 700,0 "});
  expect_lines(
      "<style>.no{stroke:none} #seen{stroke:red} g.in > line{display:none} g path { stroke-dasharray: 2 1 } *{stroke-linejoin:round}</style>"
      "<line class='a no b' x2='1'/><line class='no' id='seen' x2='2'/><g class='in'><line x2='3'/><g><line x2='4'/></g></g><g><path d='M0 9h4'/></g>",
      {"0,0 200,0 ", "0,0 400,0 ", "0,900 200,900 ", "300,900 400,900 "});
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
  EXPECT_NE(error_of(page(many + "</style>" + nest + crowd)).find("too much work"), std::string::npos);
}

TEST(SvgReader, SymbolsAndNestedDrawings) {
  expect_lines("<svg x='10' y='20' width='30' height='30' viewBox='0 0 3 3'><line x1='-1' y1='1' x2='2' y2='1'/></svg>",
               {"1000,3000 3000,3000 "}, "scaled, and cut at its frame");
  expect_lines(
      "<svg x='10' y='20' width='30' height='30' viewBox='0 0 3 3' overflow='visible'><line x1='-1' y1='1' x2='2' y2='1'/></svg>",
      {"0,3000 3000,3000 "});
  expect_lines("<svg width='50%' height='10'><line x2='100%'/></svg>", {"0,0 5000,0 "});
  const std::string symbol = "<symbol id='s' viewBox='0 0 10 10'><line x2='10' y2='10'/></symbol>";
  expect_lines(symbol + "<use xlink:href='#s' x='5' y='6' width='20' height='20'/>", {"500,600 2500,2600 "});
  expect_lines(symbol + "<use href='#s' x='5' width='0' height='20'/>", {});
  expect_lines(
      "<symbol id='r' viewBox='0 0 10 10' refX='5' refY='10'><line x2='10' y2='10'/></symbol>"
      "<use href='#r' x='50' y='60' width='20' height='20'/>",
      {"4000,4000 6000,6000 "});
  expect_lines("<symbol id='g' overflow='visible'><path d='M1 1L-4 1'/></symbol><use xlink:href='#g' x='50' y='50'/>",
               {"5100,5100 4600,5100 "});
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

TEST(SvgReader, DotsAndFills) {
  expect_lines("<path d='M5 5h0' stroke-linecap='round'/>", {"500,500 500,500 "});
  expect_lines("<path d='M5 5h0'/>", {}, "butt ends");
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
