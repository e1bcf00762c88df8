// Curves, points, colours and names on pictures of surfaces.

#include <algorithm>
#include <fstream>
#include <numbers>
#include <regex>

#include "surface_program.hpp"

namespace ligne::test {
namespace {

const Words kFromAbove = "-x -5:5:11 -y -5:5:11 --view top --page 100x100 --margin 10 --scale 8:1 --lines none";

class CurvesTest : public SurfaceProgramTest {
 protected:
  Outcome map(const Words& arguments) const { return surface(arguments + kFromAbove, "-o - --format svg"); }
  std::map<std::string, double> lengths(const Words& arguments) const {
    // Each curve is a part of its own in the layer.
    std::map<std::string, double> whole;
    for (const auto& [name, length] : layers(arguments + kFromAbove)) whole[name.substr(0, name.find('-'))] += length;
    return whole;
  }
};

TEST_F(CurvesTest, ACurveIsSeenAboveTheSurfaceAndNotBelow) {
  const double round = 2 * std::numbers::pi * 3 * 8;
  EXPECT_NEAR(lengths("x/10 --curve 3*cos(t) 3*sin(t) 1")["curve"], round, 0.01);
  EXPECT_EQ(lengths("x/10 --curve 3*cos(t) 3*sin(t) -1").count("curve"), 0u);
  EXPECT_NEAR(lengths("x/10 --curve 3*cos(t) 3*sin(t) 0")["curve"], round / 2, 0.5) << "x < 0 lies below 0";
  EXPECT_NEAR(lengths("x/10 --curve -3*cos(t) 3*sin(t) -1 --hidden dashed")["hidden"], round, 0.01);
}

TEST_F(CurvesTest, ACurveOnTheSurfaceIsSeenWhereItIs) {
  const double round = 2 * std::numbers::pi * 3 * 8;
  for (const char* formula : {"x/10", "sin(x)*cos(2*y)", "r<4.5 ? r : 0/0"}) {
    EXPECT_NEAR(lengths({formula, "--curve", "3*cos(t)", "3*sin(t)", "surface"})["curve"], round, 0.02) << formula;
  }
  EXPECT_NEAR(lengths("x --curve t 0 surface -t -20:20")["curve"], 80, 0.02) << "not beside it";
}

TEST_F(CurvesTest, WhatLeavesTheRangesEndsAtTheBox) {
  const std::vector<std::string> line{"x/10", "--curve", "t", "0", "9", "-t", "-20:20"};
  const Outcome ended = map(line);
  expect_parts(ended.err, {"1 curve leaves the ranges of -x, -y or --z-range: it ends at the box"});
  write("far.txt", "1,1,2,Near\n70,1,2,Far\n");
  const Outcome points = map({"0*x", "--points", "far.txt"});
  expect_parts(points.err, {"1 point lies outside the ranges of -x, -y or --z-range: it is left out"});
  expect_parts(points.out, {">Near</text>"});
  expect_no_parts(points.out, {">Far</text>"});
  // Without ranges the axes become wider, and the page holds the curve.
  const auto free = [&](const std::vector<std::string>& more) {
    return surface({"x/10", "--curve", "9*cos(t)", "9*sin(t)", "3", "-o", "-", "--format", "svg"}, more);
  };
  const Outcome axes = free({"--axes"});
  EXPECT_EQ(axes.err, "");
  expect_parts(axes.out, {">8</text>", ">\u22128</text>", ">3</text>"});
  EXPECT_EQ(free({}).err, "");
}

TEST_F(CurvesTest, PointsThatAreHiddenHaveNoMark) {
  write("points.txt", "x,y,z,name\n1,1,2,Above\n-2,1,-2,Below\n3,-3,On it\n40,0,Beside\n");
  const std::string file = "points.txt";
  const Outcome outcome = map({"0*x", "--points", file});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expect_parts(outcome.err, {"1 points outside the surface are omitted"});
  expect_parts(outcome.out, {">Above</text>", ">On it</text>"});
  expect_no_parts(outcome.out, {">Below</text>"});
  write("bad.txt", "1 2\n3 here\n");
  const std::string bad = "bad.txt";
  EXPECT_NE(map({"x", "--points", bad}).err.find("bad.txt:2: does not begin with two numbers"), std::string::npos);
}

TEST_F(CurvesTest, PointsComeFromTablesAndThoseNotMarkedAreCounted) {
  write("named.csv", "id,lon,lat,height,label\n1,-1,1,1,Left\n2,0,0.5,-1,Below\n3,300,0,1,Far\n");
  const std::string file = "named.csv";
  const Outcome outcome = map({"0*x", "--points", file});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expect_parts(outcome.out, {">Left</text>"});
  expect_parts(outcome.err, {"named.csv: warning: left out: 1 column (id)",
                             "1 point lies outside the ranges of -x, -y or --z-range: it is left out",
                             "1 of 2 points are not marked: 1 hidden"});
  write("semicolons.csv", "-1;1;First\n0,5;0,5;Second\n");
  const std::string semicolons = "semicolons.csv";
  const Outcome second = map({"0*x", "--points", semicolons});
  EXPECT_EQ(second.err, "");
  expect_parts(second.out, {">First</text>", ">Second</text>"});
}

TEST_F(CurvesTest, LinesOfAFileAreCurves) {
  write("way.dat", "# a way\n-3 0\n3 0\n\n0 -2\n0 2\n");
  const std::string file = "way.dat";
  EXPECT_NEAR(lengths({"0*x", "--path", file})["curve"], 10 * 8, 0.02);
  write("raised.csv", "x,y,z\n-3,0,-1\n3,0,1\n");
  const std::string raised = "raised.csv";
  EXPECT_NEAR(lengths({"0*x", "--path", raised})["curve"], 3 * 8, 0.1) << "half of it lies below";
  write("one.dat", "1 1\n\n2 2\n");
  const std::string one = "one.dat";
  EXPECT_NE(map({"x", "--path", one}).err.find("has no line"), std::string::npos);
}

TEST_F(CurvesTest, SurfacesHaveTheirColoursAndTheirNames) {
  const Outcome outcome = surface("x 0-x --colors black,red --legend --name rising", "-o - --format svg");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expect_parts(outcome.out, {"\"#f00\"", ">rising</text>"});
  EXPECT_NE(outcome.out.find(">0-x</text>"), std::string::npos) << "the formula, where there is no name";
}

TEST_F(CurvesTest, BandsDivideTheLinesByTheirHeights) {
  const Outcome outcome = surface(
      {"x", "-x", "0:10:11", "-y", "0:10:2", "--lines", "y", "--bands", "0,2,5", "--colors", "red,lime,blue", "--legend"},
      "-o - --format svg");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* text :
       {"\"#f00\"", "\"#0f0\"", "\"#00f\"", ">0 \u2013 2</text>", ">2 \u2013 5</text>", ">5 \u2013 10</text>"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
  }
}

TEST_F(CurvesTest, FillsShowTheBandsInTheirColours) {
  const Words bands = "x -x 0:10:11 -y 0:10:3 --bands 0,2,5 --fill material --colors red,lime,blue --legend --lines y";
  const Outcome outcome = surface(bands, "-o - --format svg");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::size_t fill = outcome.out.find("inkscape:label=\"fill\""),
                    lines = outcome.out.find("inkscape:label=\"horizon\"");
  ASSERT_NE(fill, std::string::npos);
  ASSERT_NE(lines, std::string::npos);
  for (const char* color : {"\"#f00\"", "\"#0f0\"", "\"#00f\""}) {
    const std::size_t at = outcome.out.find(color);
    EXPECT_TRUE(fill < at && at < lines) << color << " is that of an area";
    EXPECT_EQ(outcome.out.find(color, lines), std::string::npos) << "lines on areas are black";
  }
  EXPECT_NE(outcome.out.find("inkscape:label=\"legend\""), std::string::npos) << "samples have a frame";
  expect_parts(outcome.out, {">2 \u2013 5</text>"});
  for (const char* format : {"pdf", "png"}) EXPECT_EQ(surface(bands, {"-o", "-", "--format", format}).status, 0) << format;
}

TEST_F(CurvesTest, WaterIsNoBand) {
  const Outcome outcome =
      surface("x -x 0:10:11 -y 0:10:3 --water 4 --bands 2 --fill material --legend --colors red,lime", "-o - --format svg");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"#cce3f2\""), std::string::npos) << "the colour of water";
  EXPECT_NE(outcome.out.find(">4 \u2013 7</text>"), std::string::npos) << "bands begin at the shore";
}

TEST_F(CurvesTest, NumbersOfBandsHaveNoMoreDigitsThanTheyAreRoundedTo) {
  const Outcome outcome = surface("x -x -1.2345678:1:5 -y 0:1:2 --bands 7 --legend", "-o - --format svg");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expect_parts(outcome.out, {"\u2212"
                             "0.9153 \u2013 \u2212"
                             "0.5961</text>"});
}

TEST_F(CurvesTest, NamesOnAnAxis) {
  const Outcome outcome = surface("x+y -x 0:2:3 -y 0:2:3 --axes --x-names north,south,west", "-o - --format svg");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* text : {">north</text>", ">south</text>", ">west</text>"}) expect_parts(outcome.out, {text});
}

TEST_F(CurvesTest, TheSameBytesForAnyNumberOfThreads) {
  const Words arguments =
      "sin(x)*cos(y) --contour-step 0.2 --contour-labels --hachures slope --curve t t surface -t -3:3 "
      "--bands 4";
  EXPECT_EQ(map(arguments + "--threads 1").out, map(arguments + "--threads 2").out);
}

// Features of terrain maps: water, hachures, index contours, labels, scale bar and north arrow.

/// Seen from above, ten units of the ground are 80 mm.
const Words kMap = "-x 0:10:11 -y 0:10:11 --view top --lines none --page 100x100 --margin 10 --scale 8:1";

class TerrainTest : public SurfaceProgramTest {
 protected:
  std::map<std::string, double> map(const Words& arguments) const { return layers(arguments + kMap); }
  std::string svg(const Words& arguments) const { return surface(arguments + kMap, "-o - --format svg").out; }
};

TEST_F(TerrainTest, WaterEndsAtItsShore) {
  auto blank = map("x --water 4.3");
  EXPECT_NEAR(blank["shore"], 80, 1e-3) << "x = 4.3 from side to side";
  EXPECT_EQ(blank.count("water"), 0u);
  auto hatched = map("x --water 4.3 --water-fill hatch --pen-width 0.4");
  // A stroke every five widths of the pen.
  EXPECT_NEAR(hatched["water"], 0.43 * 80 * (80 / (5 * 0.4)), 0.43 * 80 * 1.01);
}

TEST_F(TerrainTest, FlatLandAtTheLevelIsNoWater) {
  auto drawn = map("'max(x, 5)' --water 5 --water-fill hatch");
  EXPECT_EQ(drawn.count("water"), 0u) << "nothing is lower";
}

TEST_F(TerrainTest, WaterHasNoCurvesAndNoContours) {
  const Words block =
      "-x 0:10:11 -y 0:10:11 --view top --lines y --page 100x100 --margin 10 --scale 8:1 --water 5 "
      "--contours 20:even";
  auto drawn = layers("x" + block);
  EXPECT_NEAR(drawn["horizon"], 11 * 40, 0.1) << "half of eleven rows";
  EXPECT_NEAR(drawn["contour"], 20 * 80, 0.1);
}

TEST_F(TerrainTest, HachuresLieInTheShade) {
  EXPECT_EQ(map("3 --hachures slope").count("hatch"), 0u) << "a plain";
  // A slope down to the east is dark when the sun stands in the west, and lit when it stands in the east.
  for (const std::string kind : {"contour", "slope"}) {
    EXPECT_GT(map({"10-x", "--hachures", kind, "--sun", "270"})["hatch"], 100) << kind;
    EXPECT_EQ(map({"10-x", "--hachures", kind, "--sun", "90"}).count("hatch"), 0u) << kind;
  }
}

TEST_F(TerrainTest, HachuresDownASlopeStayOnTheGround) {
  const std::string out = svg("sin(x)*cos(y)+0.1*sin(7*x)*sin(5*y) --hachures slope --outline off");
  double low = 1e9, high = -1e9;
  for (std::size_t at = out.find("<path d=\"M"); at != std::string::npos; at = out.find("<path d=\"M", at + 1)) {
    std::string path = out.substr(at + 9, out.find('"', at + 9) - at - 9);
    for (char& c : path) c = c == 'M' || c == 'L' || c == ',' || c == 'H' || c == 'V' || c == 'Z' ? ' ' : c;
    std::istringstream numbers(path);
    for (double value = 0; numbers >> value;) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  EXPECT_GE(low, 10 - 1e-3);
  EXPECT_LE(high, 90 + 1e-3);
}

TEST_F(TerrainTest, IndexContours) {
  auto drawn = map("x --contour-step 0.5");
  EXPECT_NEAR(drawn["contour-index"], 4 * 80, 1) << "2.5, 5, 7.5, 10; nothing is below 0";
  auto none = map("x --contour-step 0.5 --index-contours 0");
  EXPECT_EQ(none.count("contour-index"), 0u);
  EXPECT_NEAR(none["contour"], drawn["contour"] + drawn["contour-index"], 0.01);
}

TEST_F(TerrainTest, LabelsStandInGaps) {
  auto plain = map("x --contour-step 2 --index-contours 0");
  auto labelled = map("x --contour-step 2 --index-contours 0 --contour-labels all");
  EXPECT_LT(labelled["contour"], plain["contour"] - 4 * 2);
  const std::string out = svg("x --contour-step 2 --index-contours 0 --contour-labels all");
  for (const char* text : {">2</text>", ">4</text>", ">6</text>", ">8</text>"}) EXPECT_NE(out.find(text), out.npos) << text;
  const auto strokes = map("x --contour-step 2 --contour-labels all --text stroke");
  EXPECT_GT(strokes.at("text"), 4) << "as single strokes too";
}

TEST_F(TerrainTest, BothMethodsLabelTheSameLines) {
  const Words hill = "exp(-(x-5)^2/9-(y-5)^2/6) --contours 5 --contour-labels all";
  auto horizon = map(hill);
  EXPECT_NEAR(map(hill + "--z-range -1:2")["contour"], horizon["contour"], 0.02 * horizon["contour"]);
}

TEST_F(TerrainTest, ScaleBarAndNorth) {
  const std::string out = svg("x --scale-bar km --north-arrow --text-height 2");
  EXPECT_NE(out.find(">2 km</text>"), out.npos);
  EXPECT_NE(out.find(">N</text>"), out.npos);
  EXPECT_NE(surface("x --eye 9,9,9 --scale-bar m", "-o - --format svg").err.find("no scale"), std::string::npos);
}

TEST_F(TerrainTest, Errors) {
  const auto error = [&](const Words& arguments) { return surface(arguments, "-o - --format svg").err; };
  EXPECT_NE(error("x --contour-labels").find("needs --contours"), std::string::npos);
  EXPECT_NE(error("x --water nodata").find("needs --grid"), std::string::npos);
  EXPECT_NE(error("x --water-fill hatch").find("needs --water"), std::string::npos);
  EXPECT_NE(error("x --hachure-spacing 1").find("needs --hachures"), std::string::npos);
}

TEST_F(TerrainTest, HolesOfAGridAsWater) {
  write("holes.csv", "1,1,1,1\n1,2,2,1\n1,2,nan,nan\n1,1,nan,nan\n");
  const std::string grid = "holes.csv";
  auto drawn = layers({"--grid", grid, "--view", "top", "--lines", "none", "--water", "nodata", "--water-fill", "hatch"});
  EXPECT_GT(drawn["shore"], 1);
  EXPECT_GT(drawn["water"], 1);
}

TEST_F(TerrainTest, RidgelinesStopAtTheShore) {
  const auto strokes = [&](const Words& more) {
    const std::string out = surface("abs(x-5) -x 0:10 -y 0:10:11 --ridgeline --samples 101", more).out;
    std::size_t count = 0;
    for (std::size_t at = out.find("<path"); at != std::string::npos; at = out.find("<path", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(strokes("-o - --format svg"), 11u);
  EXPECT_EQ(strokes("--water 2 -o - --format svg"), 22u) << "a shore on either side";
}

TEST_F(TerrainTest, AxesOfRidgelinesSayTruePositions) {
  const auto drawn = [&](const std::vector<std::string>& more) {
    return surface({"sin(x)+0.1*y", "-x", "-6:6", "-y", "0:10:20", "--ridgeline", "-o", "-", "--format", "svg"}, more).out;
  };
  for (const char* style : {"--axes", "--axes=box", "--axes=base", "--axes=grid"}) {
    const std::string out = drawn({style});
    expect_parts(out, {">−6</text>", ">−2</text>", ">6</text>", ">10</text>", ">7</text>", ">1.5</text>"});
    expect_no_parts(out, {">0.35</text>", ">1.2</text>", ">0.9</text>"});
    // Lines of the axes that no longer path holds: ticks, and lines of the grid over the last row.
    const std::string axes = out.substr(out.find("id=\"axes\""));
    const std::regex straight("<path d=\"M(\\S+) (\\S+)l(\\S+) (\\S+)\"/>");
    for (std::sregex_iterator line(axes.begin(), axes.end(), straight), end; line != end; ++line) {
      const double dx = std::stod((*line)[3]), y = std::stod((*line)[2]);
      if (std::abs(dx) < 100) continue;
      EXPECT_TRUE(y > 230 || y < 90 || style == std::string("--axes=grid")) << style << ": crosses the rows at " << y;
    }
  }
  EXPECT_EQ(layers({"x*0", "-x", "0:9", "-y", "0:1:4", "--ridgeline", "--axes"}).count("axes"), 1u) << "flat rows";
}

TEST_F(TerrainTest, UnevenRowsOfRidgelinesStandAtTheirPositions) {
  write("rows.csv", ",0,1,2\n0,5,5,5\n1,5,5,5\n10,5,5,6\n");
  const std::string out = surface({"--grid", "rows.csv", "--ridgeline", "1"}, {"-o", "-", "--format", "svg"}).out;
  std::vector<double> y;
  const std::regex path("<path d=\"M\\S+ (\\S+)l");
  for (std::sregex_iterator line(out.begin(), out.end(), path), end; line != end; ++line) y.push_back(std::stod((*line)[1]));
  ASSERT_EQ(y.size(), 3u);
  std::sort(y.begin(), y.end());
  EXPECT_NEAR((y[1] - y[0]) / (y[2] - y[1]), 9, 0.01);
}

/// How long the axes of `ligne surface` are, and how they count.

using nlohmann::json;

class SurfaceScaleTest : public SurfaceProgramTest {
 protected:
  /// Width and height on the page, mm, of all that a view shows.
  std::array<double, 2> size(const Words& arguments, const std::string& view) const {
    const json drawing = drawn(arguments + Words{"--view", view, "--method", "appel"});
    Rect box;
    for (const json& stroke : drawing["strokes"]) {
      for (const json& p : stroke["points"]) box.extend(p[0], p[1]);
    }
    return {box.x1 - box.x0, box.y1 - box.y0};
  }
  /// y to x, and z to x.
  std::array<double, 2> sides(const Words& arguments) const {
    const auto top = size(arguments, "top"), front = size(arguments, "front");
    return {top[1] / top[0], front[1] / front[0]};
  }
  std::string stats(const Words& arguments) const { return surface(arguments, "--stats -o s.svg").err; }

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
  const Words sliver = "x+y/1000 -x 0:10:9 -y 0:10000:9";
  expect_sides(sides(sliver), 1, 0.5);
  expect_parts(stats(sliver), {"box: the ranges of x and y differ by a factor of 1000"});
  expect_sides(sides("x+y -x 0:10:9 -y 0:40:9"), 4, 2);
  expect_sides(sides("x+y -x 0:10:9 -y 0:40.1:9"), 1, 0.5);
}

TEST_F(SurfaceScaleTest, AspectAsAskedFor) {
  const Words wide = "x+y -x 0:20:9 -y 0:10:9";
  const auto with = [&](const Words& more) {
    Words all = wide + more;
    return sides(all);
  };
  expect_sides(with({}), 0.5, 0.5);
  expect_sides(with("--aspect box"), 1, 0.5);
  expect_sides(with("--aspect 4:3:1"), 0.75, 0.25);
  expect_sides(with("--z-scale 0.2"), 0.5, 0.3);
  expect_sides(with("--aspect box --z-scale 0.2"), 1, 0.3);
  expect_sides(with("--exaggeration 2"), 0.5, 3);
}

TEST_F(SurfaceScaleTest, WhatDoesNotGoTogether) {
  fails("x --aspect 3:2 -o a.svg", 2, "--aspect: \"3:2\" is not equal, box or X:Y:Z");
  fails("x --aspect 3:2:0 -o a.svg", 2, "--aspect: ");
  fails("x --aspect 1:1:1 --z-scale 2 -o a.svg", 2, "--aspect: X:Y:Z sets the height");
  fails("x --aspect box --exaggeration 2 -o a.svg", 2, "--exaggeration: needs --aspect equal");
  fails("x --log-x -o a.svg", 2, "--log-x: needs a range -x A:B above zero");
  fails("x --log-x -x -1:5 -o a.svg", 2, "--log-x: the range -x reaches down to zero");
}

TEST_F(SurfaceScaleTest, LogarithmicAxes) {
  // In decades x^2 y is a plane: 3 decades by 1.5, and 7.5 high.
  const Words plane = "x^2*y -x 1:1000:9 -y 1:31.6227766:9 --log-x --log-y --log-z";
  Words true_heights = plane + "--z-scale 1";
  expect_sides(sides(true_heights), 0.5, 2.5);
  const Outcome outcome = surface(plane, "--axes --text font -o - --format svg");
  for (const char* label : {">10²<", ">10³<", ">10⁶<"}) EXPECT_NE(outcome.out.find(label), std::string::npos) << label;
}

TEST_F(SurfaceScaleTest, LogarithmicAxesOfGrids) {
  std::ofstream(file("h.txt")) << "0 1 9\n0 100 9\n\n1 1 1\n1 100 3\n\n100 1 2\n100 100 4\n";
  const auto found = sides("--grid h.txt --log-x --log-y --z-scale 1");
  expect_sides(found, 1, 1.5);
}

}  // namespace
}  // namespace ligne::test
