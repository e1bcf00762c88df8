/// What the writers make of arcs.

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

/// The points of the only path, arcs followed in steps by the rules of SVG (its appendix on elliptic arcs).
std::vector<Point2> followed(const std::string& svg, int& arcs) {
  const std::size_t begin = svg.find("<path d=\"") + 9;
  std::string text = svg.substr(begin, svg.find('"', begin) - begin);
  std::vector<Point2> points;
  char command = 0;
  Point2 at{0, 0};
  std::string spaced;
  for (const char c : text)
    spaced += std::isalpha(static_cast<unsigned char>(c)) ? std::string{' ', c, ' '} : std::string{c};
  std::istringstream in(spaced);
  const auto number = [&] {
    std::string word;
    in >> word;
    return std::stod(word);
  };
  while (in >> std::ws && !in.eof()) {
    if (std::isalpha(in.peek())) in >> command;
    if (command == 'Z') break;
    double rx = 0, ry = 0, turn = 0, large = 0, sweep = 0;
    const bool relative = std::islower(command), arc = std::toupper(command) == 'A';
    if (arc) rx = number(), ry = number(), turn = number() * kDegree, large = number(), sweep = number();
    const double x = number(), y = number();
    const Point2 to = relative ? at + Point2{x, y} : Point2{x, y};
    if (arc) {
      ++arcs;
      EXPECT_EQ(large, 0);
      const double c = std::cos(turn), s = std::sin(turn);
      const Point2 half = (at - to) / 2.0, p{c * half.x + s * half.y, -s * half.x + c * half.y};
      const double below = rx * rx * p.y * p.y + ry * ry * p.x * p.x;
      const double k = std::sqrt(std::max(0.0, (rx * rx * ry * ry - below) / below)) * (large == sweep ? -1 : 1);
      const Point2 q{k * rx * p.y / ry, -k * ry * p.x / rx}, middle = (at + to) / 2.0;
      const Point2 centre = middle + Point2{c * q.x - s * q.y, s * q.x + c * q.y};
      const double from = std::atan2((p.y - q.y) / ry, (p.x - q.x) / rx),
                   end = std::atan2((-p.y - q.y) / ry, (-p.x - q.x) / rx);
      double angle = end - from;
      if (sweep != 0 && angle < 0) angle += 2 * kPi;
      if (sweep == 0 && angle > 0) angle -= 2 * kPi;
      for (int i = 0; i < 2000; ++i) points.push_back(point_at({centre, {rx, ry}, turn}, from + angle * i / 2000));
    }
    points.push_back(to);
    at = to;
  }
  return points;
}

TEST(CurvesInFiles, SvgArcsAreTheEllipse) {
  PlotOptions options;
  options.curves = true;
  for (const double turn : {0.0, 25.0, 90.0, 140.0}) {
    for (const double slender : {1.0, 0.6, 0.05}) {
      const Ellipse ellipse{{101, 90}, {20, 20 * slender}, turn * kDegree};
      int arcs = 0;
      const std::string svg = write_svg(circle_drawing(ellipse), options);
      const std::vector<Point2> points = followed(svg, arcs);
      EXPECT_GE(arcs, 3) << svg;
      EXPECT_LE(arcs, 4) << svg;
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
  int arcs = 0;
  followed(write_svg(drawing, {}), arcs);
  EXPECT_EQ(arcs, 0);
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
