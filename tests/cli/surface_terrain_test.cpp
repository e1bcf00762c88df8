// What maps of terrain have: water, hachures, index contours, labels, scale bar and north arrow.

#include "surface_program.hpp"

namespace ligne::test {
namespace {

/// Seen from above, ten units of the ground are 80 mm.
const std::vector<std::string> kMap{"-x",   "0:10:11", "-y",      "0:10:11",  "--view", "top",     "--lines",
                                    "none", "--page",  "100x100", "--margin", "10",     "--scale", "8:1"};

class TerrainTest : public SurfaceProgramTest {
 protected:
  std::map<std::string, double> map(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), kMap.begin(), kMap.end());
    return layers(arguments);
  }
  std::string svg(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), kMap.begin(), kMap.end());
    return surface(arguments, {"-o", "-", "--format", "svg"}).out;
  }
};

TEST_F(TerrainTest, WaterEndsAtItsShore) {
  auto blank = map({"x", "--water", "4.3"});
  EXPECT_NEAR(blank["shore"], 80, 1e-3) << "x = 4.3 from side to side";
  EXPECT_EQ(blank.count("water"), 0u);
  auto hatched = map({"x", "--water", "4.3", "--water-fill", "hatch", "--pen-width", "0.4"});
  // A stroke every five widths of the pen.
  EXPECT_NEAR(hatched["water"], 0.43 * 80 * (80 / (5 * 0.4)), 0.43 * 80 * 1.01);
}

TEST_F(TerrainTest, FlatLandAtTheLevelIsNoWater) {
  auto drawn = map({"max(x, 5)", "--water", "5", "--water-fill", "hatch"});
  EXPECT_EQ(drawn.count("water"), 0u) << "nothing is lower";
}

TEST_F(TerrainTest, WaterHasNoCurvesAndNoContours) {
  const std::vector<std::string> block{"-x",      "0:10:11", "-y",      "0:10:11", "--view",     "top",
                                       "--lines", "y",       "--page",  "100x100", "--margin",   "10",
                                       "--scale", "8:1",     "--water", "5",       "--contours", "20"};
  std::vector<std::string> arguments{"x"};
  arguments.insert(arguments.end(), block.begin(), block.end());
  auto drawn = layers(arguments);
  EXPECT_NEAR(drawn["horizon"], 11 * 40, 0.1) << "half of eleven rows";
  EXPECT_NEAR(drawn["contour"], 20 * 80, 0.1);
}

TEST_F(TerrainTest, HachuresLieInTheShade) {
  EXPECT_EQ(map({"3", "--hachures", "slope"}).count("hatch"), 0u) << "a plain";
  // A slope down to the east is dark when the sun stands in the west, and lit when it stands in the east.
  for (const std::string kind : {"contour", "slope"}) {
    EXPECT_GT(map({"10-x", "--hachures", kind, "--sun", "270"})["hatch"], 100) << kind;
    EXPECT_EQ(map({"10-x", "--hachures", kind, "--sun", "90"}).count("hatch"), 0u) << kind;
  }
}

TEST_F(TerrainTest, HachuresDownASlopeStayOnTheGround) {
  const std::string out = svg({"sin(x)*cos(y)+0.1*sin(7*x)*sin(5*y)", "--hachures", "slope", "--outline", "off"});
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
  auto drawn = map({"x", "--contour-step", "0.5"});
  EXPECT_NEAR(drawn["contour-index"], 4 * 80, 1) << "2.5, 5, 7.5, 10; nothing is below 0";
  auto none = map({"x", "--contour-step", "0.5", "--index-contours", "0"});
  EXPECT_EQ(none.count("contour-index"), 0u);
  EXPECT_NEAR(none["contour"], drawn["contour"] + drawn["contour-index"], 0.01);
}

TEST_F(TerrainTest, LabelsStandInGaps) {
  auto plain = map({"x", "--contour-step", "2", "--index-contours", "0"});
  auto labelled = map({"x", "--contour-step", "2", "--index-contours", "0", "--contour-labels", "all"});
  EXPECT_LT(labelled["contour"], plain["contour"] - 4 * 2);
  const std::string out = svg({"x", "--contour-step", "2", "--index-contours", "0", "--contour-labels", "all"});
  for (const char* text : {">2</text>", ">4</text>", ">6</text>", ">8</text>"}) EXPECT_NE(out.find(text), out.npos) << text;
  const auto strokes = map({"x", "--contour-step", "2", "--contour-labels", "all", "--text", "stroke"});
  EXPECT_GT(strokes.at("text"), 4) << "as single strokes too";
}

TEST_F(TerrainTest, BothMethodsLabelTheSameLines) {
  const std::vector<std::string> hill{"exp(-(x-5)^2/9-(y-5)^2/6)", "--contours", "5", "--contour-labels", "all"};
  auto horizon = map(hill);
  std::vector<std::string> mesh = hill;
  mesh.insert(mesh.end(), {"--z-range", "-1:2"});
  EXPECT_NEAR(map(mesh)["contour"], horizon["contour"], 0.02 * horizon["contour"]);
}

TEST_F(TerrainTest, ScaleBarAndNorth) {
  const std::string out = svg({"x", "--scale-bar", "km", "--north-arrow", "--text-height", "2"});
  EXPECT_NE(out.find(">2 km</text>"), out.npos);
  EXPECT_NE(out.find(">N</text>"), out.npos);
  EXPECT_NE(surface({"x", "--eye", "9,9,9", "--scale-bar", "m"}, {"-o", "-", "--format", "svg"}).err.find("no scale"),
            std::string::npos);
}

TEST_F(TerrainTest, Errors) {
  const auto error = [&](std::vector<std::string> arguments) {
    return surface(arguments, {"-o", "-", "--format", "svg"}).err;
  };
  EXPECT_NE(error({"x", "--contour-labels"}).find("goes with --contours"), std::string::npos);
  EXPECT_NE(error({"x", "--water", "nodata"}).find("goes with --grid"), std::string::npos);
  EXPECT_NE(error({"x", "--water-fill", "hatch"}).find("goes with --water"), std::string::npos);
  EXPECT_NE(error({"x", "--hachure-spacing", "1"}).find("goes with --hachures"), std::string::npos);
}

TEST_F(TerrainTest, HolesOfAGridAsWater) {
  write("holes.csv", "1,1,1,1\n1,2,2,1\n1,2,nan,nan\n1,1,nan,nan\n");
  const std::string grid = "holes.csv";
  auto drawn = layers({"--grid", grid, "--view", "top", "--lines", "none", "--water", "nodata", "--water-fill", "hatch"});
  EXPECT_GT(drawn["shore"], 1);
  EXPECT_GT(drawn["water"], 1);
}

TEST_F(TerrainTest, RidgelinesStopAtTheShore) {
  const auto strokes = [&](const std::vector<std::string>& more) {
    const std::string out =
        surface({"abs(x-5)", "-x", "0:10", "-y", "0:10:11", "--ridgeline", "--samples", "101"}, more).out;
    std::size_t count = 0;
    for (std::size_t at = out.find("<path"); at != std::string::npos; at = out.find("<path", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(strokes({"-o", "-", "--format", "svg"}), 11u);
  EXPECT_EQ(strokes({"--water", "2", "-o", "-", "--format", "svg"}), 22u) << "a shore on either side";
}

}  // namespace
}  // namespace ligne::test
