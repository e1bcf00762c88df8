/// Arcs in files: Bezier curves.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "geometry/parallel.hpp"
#include "plotting/writers.hpp"
#include "tessellated.hpp"

namespace ligne {
namespace {

Drawing circle_drawing(const Ellipse& ellipse) {
  Drawing drawing;
  drawing.layers.push_back({"outline", {}});
  drawing.layers.back().lines.add(closed(ellipse, 60));
  return drawing;
}

/// The points of the only path, curves followed in steps: M, L, C, S, their relative forms, and Z.
std::vector<Point2> followed(const std::string& svg, int& curves) {
  const std::size_t begin = svg.find("<path d=\"") + 9;
  std::string spaced;
  for (const char c : svg.substr(begin, svg.find('"', begin) - begin)) {
    spaced += std::isalpha(static_cast<unsigned char>(c)) ? std::string{' ', c, ' '} : c == '-' ? " -" : std::string{c};
  }
  std::istringstream in(spaced);
  std::vector<Point2> points;
  char command = 0;
  Point2 at{0, 0}, handle{0, 0};
  while (in >> std::ws && !in.eof()) {
    if (std::isalpha(in.peek())) in >> command;
    if (command == 'Z') break;
    const char kind = static_cast<char>(std::toupper(command));
    const auto point = [&] {
      Point2 p{0, 0};
      in >> p.x >> p.y;
      return std::islower(command) ? at + p : p;
    };
    if (kind == 'C' || kind == 'S') {
      ++curves;
      const Point2 a = kind == 'C' ? point() : at + (at - handle), b = point(), to = point();
      for (int i = 0; i < 1000; ++i) {
        const double t = i / 1000.0, u = 1 - t;
        points.push_back(u * u * u * at + 3 * u * u * t * a + 3 * u * t * t * b + t * t * t * to);
      }
      handle = b;
      at = to;
    } else {
      EXPECT_TRUE(kind == 'M' || kind == 'L') << command;
      at = point();
    }
    points.push_back(at);
  }
  return points;
}

TEST(CurvesInFiles, SvgCurvesAreTheEllipse) {
  PlotOptions options;
  options.curves = true;
  for (const double turn : {0.0, 25.0, 90.0, 140.0}) {
    for (const double slender : {1.0, 0.6, 0.05}) {
      const Ellipse ellipse{{101, 90}, {20, 20 * slender}, turn * kDegree};
      int curves = 0;
      const std::string svg = write_svg(circle_drawing(ellipse), options);
      const std::vector<Point2> points = followed(svg, curves);
      EXPECT_GE(curves, 6) << svg;
      EXPECT_LE(curves, 12) << svg;
      for (const Point2 p : points) EXPECT_LE(distance(ellipse, p), kCurveToleranceMm);
      for (const Point2 p : closed(ellipse, 60)) {
        double least = 1;
        for (std::size_t i = 1; i < points.size(); ++i) least = std::min(least, to_segment(p, points[i - 1], points[i]));
        EXPECT_LE(least, kCurveToleranceMm);
      }
    }
  }
}

TEST(CurvesInFiles, OffUnlessAskedForAndNotForLetters) {
  Drawing drawing = circle_drawing({{100, 90}, {20, 20}});
  int count = 0;
  followed(write_svg(drawing, {}), count);
  EXPECT_EQ(count, 0);
  PlotOptions curves;
  curves.curves = true;
  EXPECT_LT(write_svg(drawing, curves).size(), write_svg(drawing, {}).size());
  EXPECT_NE(write_pdf(drawing, curves), write_pdf(drawing, {}));
  EXPECT_NE(write_png(drawing, curves), write_png(drawing, {}));
  drawing.layers[0].name = "text";
  EXPECT_EQ(write_svg(drawing, curves), write_svg(drawing, {}));
  EXPECT_EQ(write_pdf(drawing, curves), write_pdf(drawing, {}));
}

TEST(CurvesInFiles, TheSameForAnyNumberOfThreads) {
  Drawing drawing = circle_drawing({{100, 90}, {20, 9}, 0.3});
  for (int i = 0; i < 400; ++i)
    drawing.layers[0].lines.add(closed({{100, 90}, {0.2 + i * 0.1, 0.2 + i * 0.07}, i * 0.1}, 60));
  PlotOptions options;
  options.curves = true;
  std::string one, four, pdf_one, pdf_four;
  run_with_threads(1, [&] { one = write_svg(drawing, options), pdf_one = write_pdf(drawing, options); });
  run_with_threads(4, [&] { four = write_svg(drawing, options), pdf_four = write_pdf(drawing, options); });
  EXPECT_EQ(one, four);
  EXPECT_EQ(pdf_one, pdf_four);
}

}  // namespace
}  // namespace ligne
