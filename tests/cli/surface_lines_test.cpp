/// Contour lines and axes of `ligne surface` by the mesh methods.

#include <chrono>

#include "surface_program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class SurfaceLinesTest : public SurfaceProgramTest {
 protected:
  std::string svg(const Words& arguments, const Words& more = {}) const {
    const Outcome outcome = surface(arguments + more, "-o - --format svg");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  std::map<std::string, double> layers_with(const Words& arguments, const Words& more) const {
    return layers(arguments + more);
  }
};

TEST_F(SurfaceLinesTest, AxesOfTheMeshAreThoseOfTheHorizon) {
  for (const char* style : {"--axes", "--axes=grid", "--axes=box", "--axes=base"}) {
    for (const Words view :
         chosen(std::string("views, ") + style, 3, {"", "--azimuth 20 --elevation -35", "--eye 30,-20,25"})) {
      Words plot = Words{"5*sin(r)/r", "-x", "-9:9:30", "-y", "-8:9:30", "--z-scale", "1", style, "--title", "hat"} + view;
      const std::string by_horizon = svg(plot);
      const double horizon = layers(plot).at("axes");
      const double mesh = layers_with(plot, "--method appel").at("axes");
      EXPECT_NEAR(mesh, horizon, 1e-3 * horizon) << style;
      const std::string by_mesh = svg(plot, "--method appel");
      EXPECT_EQ(by_mesh.substr(by_mesh.find("id=\"text\"")), by_horizon.substr(by_horizon.find("id=\"text\""))) << style;
    }
  }
}

TEST_F(SurfaceLinesTest, Logarithms) {
  const json heights = drawn("10^x -x 0:2:3 -y 0:1:2 --log-z --z-scale 1");
  for (const json& stroke : heights["strokes"]) {
    for (const json& end : stroke["source"]["ends"]) EXPECT_NEAR(end[2].get<double>(), end[0].get<double>(), 1e-12);
  }
  EXPECT_GT(layers("x --log-z -x -1:1:20").at("horizon"), 0) << "by the horizon, too; half of it are holes";
}

TEST_F(SurfaceLinesTest, MeshesOverDegreesAreNoThingsInSpace) {
  write("mesh.dat", "0 0 0\n1 0.1 0\n2 0 0\n\n0.1 1 0\n1.1 1.1 12\n2.1 1 0\n\n0 2 0\n1 2.1 0\n2 2 0\n");
  const auto highest = [&](const Words& more) {
    const Outcome outcome = surface(Words("--grid mesh.dat --as-mesh") + more, {"-o", "mesh.obj"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::istringstream text(contents(file("mesh.obj")));
    double z = 0;
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with("v ")) z = std::max(z, std::stod(line.substr(line.rfind(' '))));
    }
    return z;
  };
  EXPECT_DOUBLE_EQ(highest({}), 12);
  EXPECT_DOUBLE_EQ(highest("--ground metres"), 12);
  EXPECT_LT(highest("--ground degrees"), 2);
}

/// Bad input of `ligne surface`: one line, the exit status and no file, or a right drawing of what there is.

using SurfaceInputTest = SurfaceProgramTest;

TEST_F(SurfaceInputTest, ContoursWithoutNumberOrMemory) {
  // Ten thousand levels on a steep sheet of two million triangles would cut it into thousands of millions.
  const auto begin = std::chrono::steady_clock::now();
  fails("sin(50*x)*sin(50*y) -x 0:1:500 -y 0:1:500 --samples 1000 --contours 10000 --skirt -o out.svg", 1,
        "sin(50*x)*sin(50*y): has too many contour lines: they cut it into more than 12 million triangles\n");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_FALSE(exists("out.svg"));
  fails({"x", "--axes", "--x-label", std::string(1000, 'n'), "-o", "a.svg"}, 2,
        "--page: numbers and names of the axes leave no drawable area");
}

}  // namespace
}  // namespace ligne::test
