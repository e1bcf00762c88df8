/// SVG drawings read back, where scripts/svg_reader.txt can not say what is right.

#include "sample_drawing.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

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
  for (const Point2 p : smooth)
    if (p.x > 20.5 && p.x < 39.5) {
      EXPECT_GT(p.y, 50) << "S mirrors the control point";
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
  EXPECT_NEAR(page_of("width='960' height='480'").page.width_mm, 254, 1e-9);
  const ReadDrawing unsized = read_svg_drawing("<svg><line stroke='red' x2='96'/></svg>", "a.svg", {});
  EXPECT_TRUE(unsized.size_assumed);
  EXPECT_NEAR(unsized.page.width_mm, 1000 * 25.4 / 96, 1e-9);
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
}

TEST(SvgReader, StyleSheetsOfTooMuchWorkAreRefused) {
  std::string many = "<style>";
  for (int i = 0; i < 9000; ++i) many += "* line{stroke:red}";
  std::string nest, crowd;
  for (int i = 0; i < 100; ++i) nest += "<g>", crowd += "</g>";
  for (int i = 0; i < 12'000; ++i) nest += "<line x2='1'/>";
  EXPECT_NE(error_of(page(many + "</style>" + nest + crowd)).find("too much work"), std::string::npos);
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

TEST(SvgReader, StylesPlaceShapes) {
  const Rect disc = box_of(read("<circle style='cx:50px;cy:40px;r:5mm'/>"), "#000000");
  EXPECT_NEAR(disc.min.x, 50 - 5 * 96 / 25.4, 0.006) << "in px of the units at hand";
  EXPECT_NEAR((disc.min.y + disc.max.y) / 2, 40, 1e-9);
  const Rect ellipse = box_of(read("<ellipse cx='50' cy='50' style='rx:20px;ry:10px'/>"), "#000000");
  EXPECT_NEAR(ellipse.width(), 40, 0.012);
  EXPECT_NEAR(ellipse.height(), 20, 0.02);
}

/// The outline of a fill is that of what is seen of it.
TEST(SvgReader, ClippedFillsEndWhereTheClipPathCutsThem) {
  const auto lines = [](const std::string& clip) {
    const ReadDrawing drawing = read("<clipPath id='c'>" + clip +
                                     "</clipPath><g stroke='none' fill='red'>"
                                     "<rect width='100' height='100' clip-path='url(#c)'/></g>");
    EXPECT_EQ(drawing.drawing.layers.size(), 1u);
    return drawing.drawing.layers.at(0).lines;
  };
  const Polylines circle = lines("<circle cx='50' cy='50' r='30'/>");
  ASSERT_EQ(circle.size(), 1u);
  EXPECT_EQ(circle[0].front(), circle[0].back());
  for (const Point2 p : circle.points) EXPECT_NEAR(glm::distance(p, Point2(50, 50)), 30, 0.006);
  // A union of two parts: the borders inside it are none, and what two sides have in common is drawn once.
  const Polylines two = lines("<rect x='10' y='30' width='30' height='30'/><rect x='30' y='30' width='30' height='30'/>");
  EXPECT_NEAR(total_length(two), 2 * (50 + 30), 1e-6);
}

TEST(SvgReader, AnEllipseOfOneRadiusIsACircle) {
  for (const char* radii : {"rx='30'", "ry='30'", "rx='30' ry='auto'", "rx='auto' ry='30'", "rx='30' ry='-1'"}) {
    const std::vector<Point2> line = line_of(std::string("<ellipse cx='50' cy='50' ") + radii + "/>");
    for (const Point2 p : line) EXPECT_NEAR(glm::distance(p, Point2(50, 50)), 30, 0.006) << radii;
    EXPECT_GT(line.size(), 20u) << radii;
  }
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

TEST(SvgDocuments, InternalEntitiesAreExpanded) {
  const std::string type =
      "<?xml version='1.0'?>\n<!-- a --><!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"svg11.dtd\" [\n"
      "<!-- <!ENTITY st0 \"x\"> --><!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\n"
      "<!ENTITY st0 \"fill:none;stroke:#ED1C24;\"> <!ENTITY st0 'stroke:none'>\n"
      "<!ENTITY quoted 'a\"b'> <!ENTITY shapes '<line x2=\"5\"/>&more;'> <!ENTITY more '<line x2=\"6\"/>\n'>\n"
      "<!ENTITY % none 'x'> <!ENTITY far SYSTEM 'far.svg'> <!ENTITY amp2 '&#38;#38;'>]>\n";
  const ReadDrawing read =
      read_document(type + "<svg xmlns='&ns_svg;'" + kSize +
                    "<g style='&st0;' id='&quoted;'>&shapes;&far;</g><title>&amp; &unknown; &amp2;</title>"
                    "<![CDATA[&shapes;]]><!-- &shapes; --></svg>");
  EXPECT_EQ(lines_of(read), (Lines{"0,0 500,0 ", "0,0 600,0 "}));
  EXPECT_EQ(read.drawing.layers.at(0).name, "#ed1c24");
  EXPECT_EQ(read.omitted.list(), "1 entity of other files");
}

TEST(SvgDocuments, EntitiesDoNotMoveLines) {
  const ReadDrawing read = read_document("<!DOCTYPE svg [<!ENTITY a '\n\n\n'>]>\n<svg" + kSize + "&a;\n<image/></svg>");
  EXPECT_EQ(read.first_omitted_line, 6u);
}

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

TEST(SvgDocuments, UnitsOfLengths) {
  EXPECT_NEAR(read("<line x2='9' stroke-width='10%'/>").drawing.layers.at(0).width_mm.value(), 10, 1e-9);
  EXPECT_GT(line_of("<rect width='10' height='20' rx='5' ry='auto'/>").size(), 9u);
}

TEST(SvgDocuments, ResolutionOfTheInput) {
  const auto page_of = [](const std::string& attributes, double px_per_inch = 96) {
    return read_document("<svg " + attributes + "><line stroke='red' x2='72' y2='1in'/></svg>", px_per_inch);
  };
  const ReadDrawing paper = page_of("viewBox='0 0 595 842'");
  EXPECT_EQ(paper.paper_of_view_box, "A4");
  EXPECT_EQ(paper.paper_dpi, 72);
  EXPECT_NEAR(paper.page.width_mm, 595 * 25.4 / 96, 1e-9) << "said, not done";
  EXPECT_EQ(page_of("width='100%' height='100%' viewBox='0 0 1052.36 744.09'").paper_dpi, 90) << "lying";
  EXPECT_EQ(page_of("viewBox='0 0 2550 3300'").paper_of_view_box, "letter");
  EXPECT_EQ(page_of("viewBox='0 0 793.7 1122.5'").paper_of_view_box, "") << "right as it is";
  EXPECT_EQ(page_of("width='595' height='842' viewBox='0 0 595 842'").paper_of_view_box, "") << "has a size";
  const ReadDrawing right = page_of("viewBox='0 0 595.28 841.89'", 72);
  EXPECT_EQ(right.paper_of_view_box, "");
  EXPECT_NEAR(right.page.width_mm, 210, 0.01);
  EXPECT_NEAR(glm::distance(right.drawing.layers.at(0).lines[0].back(), Point2(25.4, 25.4)), 0, 1e-9)
      << "inches stay inches";
}

}  // namespace
}  // namespace ligne
