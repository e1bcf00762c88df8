// Curves, points, colours and names on pictures of surfaces.

#include <numbers>

#include "surface_program.hpp"

namespace ligne::test {
namespace {

const std::vector<std::string> kFromAbove{"-x",      "-5:5:11",  "-y", "-5:5:11", "--view", "top",     "--page",
                                          "100x100", "--margin", "10", "--scale", "8:1",    "--lines", "none"};

class CurvesTest : public SurfaceProgramTest {
 protected:
  Outcome map(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), kFromAbove.begin(), kFromAbove.end());
    return surface(arguments, {"-o", "-", "--format", "svg"});
  }
  std::map<std::string, double> lengths(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), kFromAbove.begin(), kFromAbove.end());
    // Each curve is a part of its own in the layer.
    std::map<std::string, double> whole;
    for (const auto& [name, length] : layers(arguments)) whole[name.substr(0, name.find('-'))] += length;
    return whole;
  }
};

TEST_F(CurvesTest, ACurveIsSeenAboveTheSurfaceAndNotBelow) {
  const double round = 2 * std::numbers::pi * 3 * 8;
  EXPECT_NEAR(lengths({"x/10", "--curve", "3*cos(t)", "3*sin(t)", "1"})["curve"], round, 0.01);
  EXPECT_EQ(lengths({"x/10", "--curve", "3*cos(t)", "3*sin(t)", "-1"}).count("curve"), 0u);
  EXPECT_NEAR(lengths({"x/10", "--curve", "3*cos(t)", "3*sin(t)", "0"})["curve"], round / 2, 0.5) << "x < 0 lies below 0";
  EXPECT_NEAR(lengths({"x/10", "--curve", "-3*cos(t)", "3*sin(t)", "-1", "--hidden", "dashed"})["hidden"], round, 0.01);
}

TEST_F(CurvesTest, ACurveOnTheSurfaceIsSeenWhereItIs) {
  const double round = 2 * std::numbers::pi * 3 * 8;
  for (const char* formula : {"x/10", "sin(x)*cos(2*y)", "r<4.5 ? r : 0/0"}) {
    EXPECT_NEAR(lengths({formula, "--curve", "3*cos(t)", "3*sin(t)", "surface"})["curve"], round, 0.02) << formula;
  }
  EXPECT_NEAR(lengths({"x", "--curve", "t", "0", "surface", "-t", "-20:20"})["curve"], 80, 0.02) << "not beside it";
}

TEST_F(CurvesTest, PointsThatAreHiddenHaveNoMark) {
  write("points.txt", "x,y,z,name\n1,1,2,Above\n-2,1,-2,Below\n3,-3,On it\n40,0,Beside\n");
  const std::string file = "points.txt";
  const Outcome outcome = map({"0*x", "--points", file});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("1 points lie beside the surface"), std::string::npos);
  EXPECT_NE(outcome.out.find(">Above</text>"), std::string::npos);
  EXPECT_NE(outcome.out.find(">On it</text>"), std::string::npos);
  EXPECT_EQ(outcome.out.find(">Below</text>"), std::string::npos);
  write("bad.txt", "1 2\n3 here\n");
  const std::string bad = "bad.txt";
  EXPECT_NE(map({"x", "--points", bad}).err.find("bad.txt:2: does not begin with two numbers"), std::string::npos);
}

TEST_F(CurvesTest, SurfacesHaveTheirColoursAndTheirNames) {
  const Outcome outcome =
      surface({"x", "0-x", "--colors", "black,red", "--legend", "--name", "rising"}, {"-o", "-", "--format", "svg"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"#f00\""), std::string::npos);
  EXPECT_NE(outcome.out.find(">rising</text>"), std::string::npos);
  EXPECT_NE(outcome.out.find(">0-x</text>"), std::string::npos) << "the formula, where there is no name";
}

TEST_F(CurvesTest, BandsDivideTheLinesByTheirHeights) {
  const Outcome outcome = surface(
      {"x", "-x", "0:10:11", "-y", "0:10:2", "--lines", "y", "--bands", "0,2,5", "--colors", "red,lime,blue", "--legend"},
      {"-o", "-", "--format", "svg"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* text :
       {"\"#f00\"", "\"#0f0\"", "\"#00f\"", ">0 \u2013 2</text>", ">2 \u2013 5</text>", ">5 \u2013 10</text>"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
  }
}

TEST_F(CurvesTest, FillsShowTheBandsInTheirColours) {
  const std::vector<std::string> bands{"x",       "-x",     "0:10:11",  "-y",       "0:10:3",        "--bands",
                                       "0,2,5",   "--fill", "material", "--colors", "red,lime,blue", "--legend",
                                       "--lines", "y"};
  const Outcome outcome = surface(bands, {"-o", "-", "--format", "svg"});
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
  EXPECT_NE(outcome.out.find(">2 \u2013 5</text>"), std::string::npos);
  for (const char* format : {"pdf", "png"}) EXPECT_EQ(surface(bands, {"-o", "-", "--format", format}).status, 0) << format;
}

TEST_F(CurvesTest, WaterIsNoBand) {
  const Outcome outcome = surface({"x", "-x", "0:10:11", "-y", "0:10:3", "--water", "4", "--bands", "2", "--fill",
                                   "material", "--legend", "--colors", "red,lime"},
                                  {"-o", "-", "--format", "svg"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"#cce3f2\""), std::string::npos) << "the colour of water";
  EXPECT_NE(outcome.out.find(">4 \u2013 7</text>"), std::string::npos) << "bands begin at the shore";
}

TEST_F(CurvesTest, NumbersOfBandsHaveNoMoreDigitsThanTheyAreRoundedTo) {
  const Outcome outcome =
      surface({"x", "-x", "-1.2345678:1:5", "-y", "0:1:2", "--bands", "7", "--legend"}, {"-o", "-", "--format", "svg"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\u2212"
                             "0.9153 \u2013 \u2212"
                             "0.5961</text>"),
            std::string::npos);
}

TEST_F(CurvesTest, NamesOnAnAxis) {
  const Outcome outcome = surface({"x+y", "-x", "0:2:3", "-y", "0:2:3", "--axes", "--x-names", "north,south,west"},
                                  {"-o", "-", "--format", "svg"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* text : {">north</text>", ">south</text>", ">west</text>"})
    EXPECT_NE(outcome.out.find(text), std::string::npos);
}

TEST_F(CurvesTest, TheSameBytesForAnyNumberOfThreads) {
  const std::vector<std::string> arguments{"sin(x)*cos(y)",
                                           "--contour-step",
                                           "0.2",
                                           "--contour-labels",
                                           "--hachures",
                                           "slope",
                                           "--curve",
                                           "t",
                                           "t",
                                           "surface",
                                           "-t",
                                           "-3:3",
                                           "--bands",
                                           "4"};
  std::vector<std::string> one = arguments, two = arguments;
  one.insert(one.end(), {"--threads", "1"});
  two.insert(two.end(), {"--threads", "2"});
  EXPECT_EQ(map(one).out, map(two).out);
}

}  // namespace
}  // namespace ligne::test
