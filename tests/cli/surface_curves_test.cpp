// Fills and terrain maps: what scripts/surface.txt can not measure.

#include <regex>

#include "surface_program.hpp"

namespace ligne::test {
namespace {

/// Seen from above, ten units of the ground are 80 mm.
const Words kMap = "-x 0:10:11 -y 0:10:11 --view top --lines none --page 100x100 --margin 10 --scale 8:1";

class TerrainTest : public SurfaceProgramTest {
 protected:
  std::string svg(const Words& arguments) const { return surface(arguments + kMap, "-o - --format svg").out; }
};

TEST_F(TerrainTest, FillsShowTheBandsInTheirColours) {
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

}  // namespace
}  // namespace ligne::test
