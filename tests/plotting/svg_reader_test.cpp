/// SVG and JSON drawings read back: drawn right, or refused by name.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

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
         "width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\" fill=\"none\" stroke=\"black\" " + attributes + ">\n" + body + "\n</svg>";
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
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(glm::distance(got[i], wanted[i]), 0, 1e-9) << body << " point " << i;
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
  for (const char* body : {"<circle cx='50' cy='50' r='40'/>", "<ellipse cx='50' cy='50' rx='40' ry='40'/>", "<path d='M90 50A40 40 0 1 1 10 50A40 40 0 0 1 90 50'/>",
                           "<path d='M90 50a40 40 0 01-80 0 40 40 0 0180 0'/>", "<rect x='10' y='10' width='80' height='80' rx='40'/>"}) {
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
  for (const char* body : {"<path d='M0 0Q50 100 100 0'/>", "<path d='M0 0C33.3333333333 66.6666666667 66.6666666667 66.6666666667 100 0'/>", "<path d='M0 0q25 50 50 50t50-50'/>"}) {
    for (const Point2 p : line_of(body)) EXPECT_NEAR(p.y, 2 * p.x * (1 - p.x / 100), 1e-6) << body;
  }
  const std::vector<Point2> smooth = line_of("<path d='M0 50C0 30 20 30 20 50S40 70 40 50'/>");
  for (const Point2 p : smooth) {
    if (p.x > 20.5 && p.x < 39.5) {
      EXPECT_GT(p.y, 50) << "S mirrors the control point";
    }
  }
}

TEST(SvgReader, TransformsUnitsAndGroups) {
  expect_points("<g transform='translate(10,20)'><line x2='1' transform='rotate(90)scale(2,3)'/></g>", {{10, 20}, {10, 22}});
  expect_points("<line x2='10' transform='rotate(90 5 0)'/>", {{5, -5}, {5, 5}});
  expect_points("<line x1='1' y1='2' x2='3' y2='4' transform='matrix(1 2 3 4 5 6)'/>", {{12, 16}, {20, 28}});
  expect_points("<line y2='10' transform='skewX(45)'/>", {{0, 0}, {10, 10}});
  const auto pixels = read_svg_drawing("<svg width='960' height='480'><line stroke='red' x2='96' y2='1in'/></svg>", "a.svg", {});
  EXPECT_NEAR(pixels.page.width_mm, 254, 1e-9);
  EXPECT_NEAR(glm::distance(pixels.drawing.layers[0].lines[0][1], Point2(25.4, 25.4)), 0, 1e-9);
  EXPECT_EQ(pixels.drawing.layers[0].name, "#ff0000");
  const auto wide = read_svg_drawing("<svg width='100mm' height='50mm' viewBox='0 0 10 10'><line stroke='red' x2='10'/></svg>", "a.svg", {});
  EXPECT_NEAR(glm::distance(wide.drawing.layers[0].lines[0][0], Point2(25, 0)), 0, 1e-9) << "xMidYMid";
}

TEST(SvgReader, LinksLayersAndWhatDoesNotShow) {
  expect_points("<defs><line id='l' x2='5'/></defs><use xlink:href='#l' x='3' y='4'/>", {{3, 4}, {8, 4}});
  expect_points("<line x2='5'/><g display='none'><line x2='9'/></g><line x2='7' stroke='none'/><line x2='8' visibility='hidden'/><line x2='4' style='stroke-opacity:0'/>",
                {{0, 0}, {5, 0}});
  const ReadDrawing layers = read("<g inkscape:groupmode='layer' inkscape:label='2 fine'><g stroke='red'><line x2='1'/></g></g><line x2='2' stroke='#00f'/>");
  ASSERT_EQ(layers.drawing.layers.size(), 2u);
  EXPECT_EQ(layers.drawing.layers[0].name, "2 fine");
  EXPECT_EQ(layers.drawing.layers[1].name, "#0000ff");
  EXPECT_EQ(read("<rect width='100' height='100' fill='white' stroke='none'/><line x2='3'/>").drawing.layers.size(), 1u);
  const ReadDrawing dashed = read("<line x2='10' stroke-dasharray='2 1'/>");
  EXPECT_EQ(dashed.drawing.layers[0].lines.size(), 4u);
}

TEST(SvgReader, TextStandsWhereItIsWritten) {
  const ReadDrawing drawing = read("<g font-size='10'><text x='20' y='30' text-anchor='middle'><tspan>A &amp; B</tspan></text></g>"
                                   "<text transform='translate(5 60) rotate(-90)' font-size='10'>up</text>");
  ASSERT_EQ(drawing.drawing.texts.size(), 2u);
  EXPECT_EQ(drawing.drawing.texts[0].text, "A & B");
  EXPECT_EQ(drawing.drawing.texts[0].at, Point2(20, 30));
  EXPECT_EQ(drawing.drawing.texts[0].across, TextAcross::center);
  EXPECT_NEAR(drawing.drawing.texts[0].height_mm, 7.29, 0.01);
  EXPECT_NEAR(drawing.drawing.texts[1].rotation_degrees, 90, 1e-9);
}

TEST(SvgReader, RefusesByName) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"<image href='a.png'/>", "<image> has image"},
      {"<path d='M0 0L9 0 9 9z' fill='red'/>", "<path> has fill"},
      {"<line x2='5'/><rect width='9' height='9' fill='white'/>", "<rect> has fill"},
      {"<g clip-path='url(#c)'><line x2='5'/></g>", "<g> has clip-path"},
      {"<line x2='5' style='mask:url(#m)'/>", "<line> has mask"},
      {"<line x2='5' filter='url(#m)'/>", "<line> has filter"},
      {"<line x2='5' marker-end='url(#m)'/>", "<line> has marker"},
      {"<line x2='5' stroke='url(#gradient)'/>", "<line> has paint"},
      {"<style>line{stroke:none}</style>", "<style> has style"},
      {"<foreignObject/>", "has foreignObject"},
      {"<switch/>", "has switch"},
      {"<svg/>", "has svg"},
      {"<text x='1' dy='3'>a</text>", "<text> has text"},
      {"<text transform='skewX(20)'>a</text>", "<text> has text"},
      {"<text><textPath href='#p'>a</textPath></text>", "has text"},
      {"<line x2='5'><animate/></line><animate/>", "has animation"},
      {"<blink/>", "<blink> is not known"},
      {"<line x2='5' stroke='?'/>", "is not a colour"},
      {"<line x2='5furlongs'/>", "is not a length"},
      {"<path d='L1 2'/>", "do not begin with M"},
      {"<path d='M1 2X3'/>", "unknown command"},
      {"<path d='M1 2L3'/>", "number"},
      {"<polyline points='1 2 3'/>", "odd number"},
      {"<g transform='spin(3)'/>", "transforms"},
      {"<line x2='1e300' transform='scale(1e300)'/>", "kilometre"},
      {"<line x2='nan'/>", "number"},
      {"<use xlink:href='other.svg#a'/>", "leads out of the file"},
      {"<g id='a'><use xlink:href='#a'/></g>", "leads on more than"},
  };
  for (const auto& [body, wanted] : cases) {
    const std::string error = error_of(page(body));
    EXPECT_NE(error.find(wanted), std::string::npos) << body << ": " << error;
    EXPECT_TRUE(error.starts_with("a.svg:2: ")) << error;
  }
  EXPECT_NE(error_of("<svg").find("is not XML"), std::string::npos);
  EXPECT_NE(error_of("<html/>").find("is not an SVG"), std::string::npos);
  EXPECT_NE(error_of("").find("is not XML"), std::string::npos);
  EXPECT_NE(error_of("<svg><line/></svg>").find("neither a width nor a viewBox"), std::string::npos);
}

TEST(SvgReader, LeavesOutWhatMayBeLeftOut) {
  const ReadDrawing drawing = read_svg_drawing(page("<image/><image/><path d='M0 0L9 0 9 9z' fill='red'/>"), "a.svg", {"image", "fill"});
  EXPECT_EQ(drawing.left_out.at("image"), 2u);
  EXPECT_EQ(drawing.left_out.at("fill"), 1u);
  EXPECT_EQ(drawing.drawing.layers.at(0).lines.size(), 1u);
}

TEST(SvgReader, BombsDoNoHarm) {
  const auto start = std::chrono::steady_clock::now();
  std::string entities = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\">";
  for (char c = 'b'; c < 'z'; ++c) entities += std::string("<!ENTITY ") + c + " \"" + std::string(10, '&') + static_cast<char>(c - 1) + ";\">";
  EXPECT_NE(error_of(entities + "]>" + page("<text>&y;</text>")).find("entity"), std::string::npos);
  EXPECT_NE(error_of(entities + "]>" + page("<line x2='&y;'/>")), "");

  std::string links = "<g id='a0'><line x2='1'/></g>";
  for (int i = 1; i < 12; ++i) {
    links += "<g id='a" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) links += "<use xlink:href='#a" + std::to_string(i - 1) + "'/>";
    links += "</g>";
  }
  EXPECT_NE(error_of(page(links)), "");

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
  const std::string head = "{\"format\":\"ligne-drawing\",\"version\":1,\"page\":{\"width_mm\":210,\"height_mm\":297,\"margin_mm\":10},";
  const std::string stroke = "{\"class\":\"outline\",\"visible\":true,\"points\":[[1,2],[3,4]]}";
  EXPECT_EQ(read_json_drawing(head + "\"strokes\":[" + stroke + "]}", "a.json").drawing.layers.size(), 1u);
  std::string deep(200'000, '[');
  for (const std::string& wrong : {std::string("{"), std::string("[]"), std::string("{}"), head + "\"order\":[]}", head + "\"strokes\":[{}]}",
                                   head + "\"strokes\":[{\"class\":\"ink\",\"visible\":true,\"points\":[[1,2],[3,4]]}]}",
                                   head + "\"strokes\":[{\"class\":\"mesh\",\"visible\":1,\"points\":[[1,2],[3,4]]}]}",
                                   head + "\"strokes\":[{\"class\":\"mesh\",\"visible\":true,\"points\":[[1,2]]}]}",
                                   head + "\"strokes\":[{\"class\":\"mesh\",\"visible\":true,\"points\":[[1,2],[3,1e9]]}]}",
                                   head + "\"strokes\":[],\"strokes\":[]}", std::string("{\"format\":\"ligne-drawing\",\"version\":2,\"strokes\":[]}"), deep,
                                   std::string("{\"format\":\"ligne-drawing\",\"version\":1,\"page\":{\"width_mm\":0},\"strokes\":[]}")}) {
    EXPECT_THROW(read_json_drawing(wrong, "a.json"), std::runtime_error) << wrong.substr(0, 200);
  }
}

}  // namespace
}  // namespace ligne
