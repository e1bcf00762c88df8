/// How long the axes of `ligne surface` are, and how they count.

#include <algorithm>
#include <fstream>

#include "surface_program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class SurfaceScaleTest : public SurfaceProgramTest {
 protected:
  /// Width and height on the page, mm, of all that a view shows.
  std::array<double, 2> size(std::vector<std::string> arguments, const std::string& view) const {
    arguments.insert(arguments.end(), {"--view", view, "--method", "appel"});
    const json drawing = drawn(arguments);
    Rect box;
    for (const json& stroke : drawing["strokes"]) {
      for (const json& p : stroke["points"]) box.extend(p[0], p[1]);
    }
    return {box.x1 - box.x0, box.y1 - box.y0};
  }
  /// y to x, and z to x.
  std::array<double, 2> sides(const std::vector<std::string>& arguments) const {
    const auto top = size(arguments, "top"), front = size(arguments, "front");
    return {top[1] / top[0], front[1] / front[0]};
  }
  std::string stats(std::vector<std::string> arguments) const { return surface(arguments, {"--stats", "-o", "s.svg"}).err; }

 private:
  struct Rect {
    double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9;
    void extend(double x, double y) {
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
  };
};

constexpr double kPart = 1e-4;

void expect_sides(const std::array<double, 2>& found, double y, double z) {
  EXPECT_NEAR(found[0], y, kPart);
  EXPECT_NEAR(found[1], z, kPart);
}

TEST_F(SurfaceScaleTest, GroundOfUnlikeRangesIsABox) {
  const std::vector<std::string> sliver{"x+y/1000", "-x", "0:10:9", "-y", "0:10000:9"};
  expect_sides(sides(sliver), 1, 0.5);
  EXPECT_NE(stats(sliver).find("box: the ranges of x and y differ by a factor of 1000"), std::string::npos) << stats(sliver);
  expect_sides(sides({"x+y", "-x", "0:10:9", "-y", "0:40:9"}), 4, 2);
  expect_sides(sides({"x+y", "-x", "0:10:9", "-y", "0:40.1:9"}), 1, 0.5);
}

TEST_F(SurfaceScaleTest, AspectAsAskedFor) {
  const std::vector<std::string> wide{"x+y", "-x", "0:20:9", "-y", "0:10:9"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = wide;
    all.insert(all.end(), more.begin(), more.end());
    return sides(all);
  };
  expect_sides(with({}), 0.5, 0.5);
  expect_sides(with({"--aspect", "box"}), 1, 0.5);
  expect_sides(with({"--aspect", "4:3:1"}), 0.75, 0.25);
  expect_sides(with({"--z-scale", "0.2"}), 0.5, 0.3);
  expect_sides(with({"--aspect", "box", "--z-scale", "0.2"}), 1, 0.3);
  expect_sides(with({"--exaggeration", "2"}), 0.5, 3);
}

TEST_F(SurfaceScaleTest, WhatDoesNotGoTogether) {
  fails({"x", "--aspect", "3:2", "-o", "a.svg"}, 2, "--aspect: \"3:2\" is not equal, box or X:Y:Z");
  fails({"x", "--aspect", "3:2:0", "-o", "a.svg"}, 2, "--aspect: ");
  fails({"x", "--aspect", "1:1:1", "--z-scale", "2", "-o", "a.svg"}, 2, "--aspect: X:Y:Z says how high");
  fails({"x", "--aspect", "box", "--exaggeration", "2", "-o", "a.svg"}, 2, "--exaggeration: needs --aspect equal");
  fails({"x", "--log-x", "-o", "a.svg"}, 2, "--log-x: needs a range -x A:B above zero");
  fails({"x", "--log-x", "-x", "-1:5", "-o", "a.svg"}, 2, "--log-x: the range -x reaches down to zero");
}

TEST_F(SurfaceScaleTest, LogarithmicAxes) {
  // In decades x^2 y is a plane: 3 decades by 1.5, and 7.5 high.
  const std::vector<std::string> plane{"x^2*y", "-x", "1:1000:9", "-y", "1:31.6227766:9", "--log-x", "--log-y", "--log-z"};
  std::vector<std::string> true_heights = plane;
  true_heights.insert(true_heights.end(), {"--z-scale", "1"});
  expect_sides(sides(true_heights), 0.5, 2.5);
  const Outcome outcome = surface(plane, {"--axes", "--text", "font", "-o", "-", "--format", "svg"});
  for (const char* label : {">10²<", ">10³<", ">10⁶<"}) EXPECT_NE(outcome.out.find(label), std::string::npos) << label;
}

TEST_F(SurfaceScaleTest, LogarithmicAxesOfGrids) {
  std::ofstream(file("h.txt")) << "0 1 9\n0 100 9\n\n1 1 1\n1 100 3\n\n100 1 2\n100 100 4\n";
  const auto found = sides({"--grid", "h.txt", "--log-x", "--log-y", "--z-scale", "1"});
  expect_sides(found, 1, 1.5);
}

}  // namespace
}  // namespace ligne::test
