/// What clip paths, masks and filled areas of an SVG drawing hide.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

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

TEST(SvgReader, TextShowsThroughClipPathsInPart) {
  const std::string text = "<text x='10' y='20' font-size='10' clip-path='url(#c)'>HHHH</text>";
  EXPECT_NEAR(text_box("<clipPath id='c'><rect width='100' height='100'/></clipPath>" + text).max.y, 20, 1e-9);
  const Rect half = text_box("<clipPath id='c'><rect width='100' height='16'/></clipPath>" + text);
  EXPECT_NEAR(half.max.y, 16, 1e-9);
  EXPECT_LT(half.min.y, 16);
}

}  // namespace
}  // namespace ligne
