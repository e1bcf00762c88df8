/// Lines and areas as the SVG has them after Cairo drew them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "plotting/drawing_reader.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

/// The paths of the drawing, one a line.
std::string paths_of(const Drawing& drawing, const PlotOptions& options = {}) {
  const std::string svg = write_svg(drawing, options);
  std::string paths;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) {
    paths += svg.substr(at, svg.find('\n', at) - at + 1);
  }
  return paths;
}

std::string path_of(const std::vector<Point2>& line) {
  Drawing drawing;
  add_line(drawing, "mesh", line);
  return paths_of(drawing);
}

TEST(SvgPaths, ALineOfNoLengthIsADot) {
  EXPECT_EQ(path_of({{5, 6}, {5, 6}}), "<path d=\"M5 6h0\"/>\n");
  EXPECT_EQ(path_of({{5, 6}, {5.00001, 6}}), "") << "shorter than a unit";
  EXPECT_EQ(path_of({{5, 6}}), "");
}

TEST(SvgPaths, AClosedLineEndsWithZ) {
  EXPECT_EQ(path_of({{10, 10}, {20, 10}, {20, 20}, {10, 10}}), "<path d=\"M10 10l10 0 0 10Z\"/>\n");
  EXPECT_EQ(path_of({{10, 10}, {20, 10}, {10, 10}}), "<path d=\"M10 10l10 0 -10 0\"/>\n") << "there and back";
}

TEST(SvgPaths, WhatLiesBeyondThePageStays) {
  Drawing drawing;
  add_line(drawing, "mesh", {{-30, -40}, {-20, -50}});
  add_line(drawing, "mesh", {{500, 600}, {700, 800}});
  add_line(drawing, "outline", {{-3000, 5}, {-2000, 6}});
  EXPECT_EQ(paths_of(drawing),
            "<path d=\"M-30 -40l10 -10\"/>\n<path d=\"M500 600L700 800\"/>\n<path d=\"M-3000 5l1000 1\"/>\n");
}

TEST(SvgPaths, CoordinatesAreRightOnPagesOfAnySize) {
  for (const double side : {0.1, 100.0, 1000.0, 1189.0, 20000.0, 100000.0}) {
    PlotOptions options;
    options.page = {side, side, 0};
    Drawing drawing;
    add_line(drawing, "mesh", {{0.0123 * side, 0.7}, {side, 0.3333 * side}});
    const std::string path = paths_of(drawing, options);
    double x = 0, y = 0, to_x = 0, to_y = 0;
    char command = 0;
    ASSERT_EQ(std::sscanf(path.c_str(), "<path d=\"M%lf %lf%c%lf %lf\"/>", &x, &y, &command, &to_x, &to_y), 5) << path;
    if (command == 'l') to_x += x, to_y += y;
    EXPECT_NEAR(x, 0.0123 * side, 3e-4) << side;
    EXPECT_NEAR(y, 0.7, 3e-4) << side;
    EXPECT_NEAR(to_x, side, 3e-4) << side;
    EXPECT_NEAR(to_y, 0.3333 * side, 3e-4) << side;
  }
}

TEST(SvgPaths, AnEmptyLayerStaysALayer) {
  Drawing drawing;
  drawing.layers.push_back({"mesh", {}});
  const std::string svg = write_svg(drawing, {});
  EXPECT_NE(svg.find("id=\"mesh\""), std::string::npos);
  EXPECT_EQ(svg.find("<path"), std::string::npos);
}

TEST(SvgPaths, DashesStayDashesHoweverShort) {
  for (const double width : {0.001, 0.1, 50.0}) {
    Drawing drawing;
    add_line(drawing, "hidden", {{10, 10}, {100, 10}});
    PlotOptions options;
    options.pen_width_mm = width;
    EXPECT_EQ(paths_of(drawing, options), "<path d=\"M10 10l90 0\"/>\n");
    EXPECT_NE(write_svg(drawing, options).find("stroke-dasharray=\""), std::string::npos);
  }
}

TEST(SvgPaths, AreasKeepHolesRimsAndOpacity) {
  const std::vector<Point2> outer{{10, 10}, {40, 10}, {40, 40}, {10, 40}}, hole{{20, 20}, {30, 20}, {30, 30}, {20, 30}};
  Drawing drawing;
  drawing.fills.push_back({{outer, hole}, {1, 0, 0}});
  drawing.fills.push_back({{hole}, {1, 0, 0}});
  drawing.fills.push_back({{outer}, {0.5, 0.25, 0}, 0.4});
  EXPECT_EQ(
      paths_of(drawing),
      "<path fill=\"#f00\" stroke=\"#f00\" d=\"M10 10l30 0 0 30 -30 0ZM20 20l10 0 0 10 -10 0ZM20 20l10 0 0 10 -10 0Z\"/>\n"
      "<path fill=\"#804000\" fill-opacity=\"0.4\" d=\"M10 10l30 0 0 30 -30 0Z\"/>\n");
  EXPECT_NE(write_svg(drawing, {}).find("id=\"fill\" fill-rule=\"evenodd\" stroke-width=\"0.15\""), std::string::npos);
}

TEST(SvgPaths, ManyAreasTakeNoTimeWithTheSquareOfTheirNumber) {
  Drawing drawing;
  for (int i = 0; i < 30000; ++i) {
    const double x = i % 200, y = i / 200;
    drawing.fills.push_back({{{{x, y}, {x + 1, y}, {x, y + 1}}}, {i % 256 / 255.0, 0, 0}});
  }
  const std::string paths = paths_of(drawing);
  EXPECT_EQ(std::ranges::count(paths, '\n'), 30000);
}

TEST(SvgPaths, ReadBackTheyAreTheLinesThatWereDrawn) {
  const Drawing drawing = sample_drawing();
  PlotOptions options;
  options.hidden_solid = true;  // dashes are read as lines of their own
  const ReadDrawing back = read_svg_drawing(write_svg(drawing, options), "a.svg", {});
  ASSERT_EQ(back.drawing.layers.size(), drawing.layers.size());
  for (std::size_t l = 0; l < drawing.layers.size(); ++l) {
    const Polylines &drawn = drawing.layers[l].lines, &read = back.drawing.layers[l].lines;
    EXPECT_EQ(back.drawing.layers[l].name, drawing.layers[l].name);
    ASSERT_EQ(read.begin, drawn.begin);
    for (std::size_t i = 0; i < drawn.points.size(); ++i) {
      EXPECT_NEAR(read.points[i].x, drawn.points[i].x, 1e-4);
      EXPECT_NEAR(read.points[i].y, drawn.points[i].y, 1e-4);
    }
  }
}

}  // namespace
}  // namespace ligne
