/// HPGL as hp2xx reads it, a program that is not ours.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "plotted.hpp"

namespace ligne {
namespace {

using namespace test;

bool hp2xx_is_there() { return std::system("command -v hp2xx >/dev/null 2>&1") == 0; }

/// Points of the paths of hp2xx's SVG, in its units of 1/90 inch.
std::vector<Point2> hp2xx_points(const std::string& hpgl) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("ligne-hp2xx-" + std::to_string(std::hash<std::string>{}(hpgl)));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "in.hpgl", std::ios::binary) << hpgl;
  const std::string command = "cd '" + folder.string() + "' && hp2xx -q -N -t -m svg -f out.svg in.hpgl >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream in(folder / "out.svg");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove_all(folder);
  std::vector<Point2> points;
  for (std::size_t at = text.find("<path d=\""); at != std::string::npos; at = text.find("<path d=\"", at + 1)) {
    std::istringstream data(text.substr(at + 9, text.find('"', at + 9) - at - 9));
    std::string word;
    double x = 0;
    char comma = 0;
    while (data >> word) {
      if (word != "M" && word != "L") continue;
      Point2 p{0, 0};
      if (data >> x >> comma >> p.y) points.push_back({x, p.y});
    }
  }
  return points;
}

class Hp2xx : public testing::TestWithParam<std::string> {};

TEST_P(Hp2xx, ReadsTheSameDrawingOfTheSameSize) {
  if (!hp2xx_is_there()) GTEST_SKIP() << "hp2xx is not installed";
  const Device& device = *find_device(GetParam());
  Drawing drawing = plotter_drawing();
  const Written w = written(device, drawing, true);
  const std::vector<Point2> read = hp2xx_points(w.text);
  ASSERT_FALSE(read.empty());
  // hp2xx takes a unit for 0.025 mm, puts the lower left of the drawing into a corner, and fits its SVG to a page: shapes
  // are compared, at our width. That sizes are true its G-code tells, below.
  constexpr double kUnitMm = 0.025;
  Rect ours, theirs;
  std::vector<Point2> points;
  for (const auto& stroke : test::replay_hpgl(w.text).strokes) {
    for (const Point2 p : stroke) points.push_back(p * kUnitMm);
  }
  for (const Point2 p : points) ours.extend(p);
  Rect pixels;
  for (const Point2 p : read) pixels.extend(p);
  const double pixel_mm = ours.width() / pixels.width();
  for (const Point2 p : read) theirs.extend(p * pixel_mm);
  constexpr double kWithinMm = 0.05;
  EXPECT_NEAR(theirs.height(), ours.height(), kWithinMm);
  const auto nearest = [](Point2 p, const std::vector<Point2>& all) {
    double least = 1e300;
    for (const Point2 q : all) least = std::min(least, glm::distance(p, q));
    return least;
  };
  std::vector<Point2> shifted;
  for (const Point2 p : read)
    shifted.push_back({p.x * pixel_mm - theirs.min.x + ours.min.x, theirs.max.y - p.y * pixel_mm + ours.min.y});
  for (const Point2 p : points) EXPECT_LE(nearest(p, shifted), kWithinMm) << p.x << " " << p.y;
  for (const Point2 p : shifted) EXPECT_LE(nearest(p, points), kWithinMm) << p.x << " " << p.y;
}

INSTANTIATE_TEST_SUITE_P(Devices, Hp2xx, testing::Values("hp7475a", "hp7550a", "designjet", "cutter"));

TEST(Hp2xxGcode, ALineOf25MillimetresIs25Millimetres) {
  if (!hp2xx_is_there()) GTEST_SKIP() << "hp2xx is not installed";
  Drawing drawing;
  add_line(drawing, "outline", {{100, 100}, {125, 100}});
  add_line(drawing, "outline", {{100, 110}, {100, 135}});
  const std::string hpgl = written(*find_device("cutter"), drawing, false).text;
  const auto folder = std::filesystem::temp_directory_path() / "ligne-hp2xx-nc";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "in.hpgl") << hpgl;
  ASSERT_EQ(std::system(("cd '" + folder.string() + "' && hp2xx -q -N -t -m nc -f out.nc in.hpgl >/dev/null 2>&1").c_str()),
            0);
  std::ifstream in(folder / "out.nc");
  std::string line;
  Point2 at{0, 0};
  std::vector<double> lengths;
  while (std::getline(in, line)) {
    double x = 0, y = 0;
    if (std::sscanf(line.c_str(), "G01 X %lf Y %lf", &x, &y) == 2) {
      if (glm::distance(at, Point2(x, y)) > 0.01) lengths.push_back(glm::distance(at, Point2(x, y)));
      at = {x, y};
    } else if (std::sscanf(line.c_str(), "G00 X %lf Y %lf", &x, &y) == 2) {
      at = {x, y};
    }
  }
  std::filesystem::remove_all(folder);
  ASSERT_EQ(lengths.size(), 2u);
  for (const double length : lengths) EXPECT_NEAR(length, 25, 0.01);
}

}  // namespace
}  // namespace ligne
