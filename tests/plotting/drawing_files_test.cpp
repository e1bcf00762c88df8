/// Drawings as files: of other programs, hostile ones, our own, and in JSON.

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "plotting/paths/optimize.hpp"
#include "plotting/writers.hpp"
#include "sample_drawing.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

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
