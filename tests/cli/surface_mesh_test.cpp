/// The command `ligne surface` by the mesh methods.

#include <algorithm>
#include <numbers>

#include "surface_program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

using SurfaceMeshTest = SurfaceProgramTest;

TEST_F(SurfaceMeshTest, TwoPlanesCrossAlongALine) {
  // 11 curves in steps of 0.3, so that the line x = 0 where the planes meet is none of them.
  const Words planes = "x -1*x -x -1:2:11 -y -1:1:5 --z-scale 1";
  const auto with = [&](const Words& view) { return drawn(planes + view); };
  const json top = with("--view top");
  EXPECT_NEAR(length(top, "intersection"), 2, kMicrometre);
  for (const json& stroke : top["strokes"]) {
    if (stroke["class"] != "intersection") continue;
    for (const json& end : stroke["source"]["ends"]) {
      EXPECT_NEAR(end[0].get<double>(), 0, 1e-6);
      EXPECT_NEAR(end[2].get<double>(), 0, 1e-6);
    }
  }
  EXPECT_NEAR(length(with("--view front"), "intersection"), 0, kMicrometre) << "seen end on";
}

TEST_F(SurfaceMeshTest, SurfacesThatCrossAlongTheirOwnEdges) {
  // Three samples each way: the planes meet along a column of samples, which is a curve or not.
  for (const char* curves : {"2", "3"}) {
    const json planes = drawn({"x", "(-x)", "-x", std::string("-1:1:") + curves, "-y", "-1:1:2", "--samples", "3",
                               "--z-scale", "1", "--azimuth", "-120"});
    // The line, 2 long, makes an angle with the sight whose cosine is sin(120) cos(30).
    EXPECT_NEAR(length(planes, "intersection"), 2 * std::sqrt(1 - 0.75 * 0.75), kMicrometre) << curves;
  }
  // A saddle and the plane through it: two lines, each 2 long.
  EXPECT_NEAR(length(drawn("x^2-y^2 0 -x -1:1:5 -y -1:1:5 --samples 9 --z-scale 1 --view top"), "intersection"),
              2 * std::sqrt(8.0), kMicrometre);
  EXPECT_NEAR(length(drawn("x*y 0 -x -1:1:5 -y -1:1:5 --z-scale 1 --view top"), "intersection"), 4 - 4 * 0.1, kMicrometre)
      << "the two triangles at the origin lie in the plane";
}

TEST_F(SurfaceMeshTest, TorusFromAbove) {
  const json torus = drawn(
      "--parametric (3+cos(v))*cos(u) (3+cos(v))*sin(u) sin(v) -u 0:2*pi:25 -v 0:2*pi:21 --samples 2 "
      "--lines x --view top");
  // Seen from above the outer and the inner equator are the outline: polygons of 24 sides.
  const double sides = 24;
  EXPECT_NEAR(length(torus, "outline"), 2 * sides * std::sin(std::numbers::pi / sides) * (4 + 2), kMicrometre);
  // Each curve of constant u is half a polygon of 20 sides, seen from above as the straight line from r = 2 to r = 4.
  EXPECT_NEAR(length(torus, "horizon"), sides * 2, kMicrometre);
  EXPECT_EQ(length(torus, "intersection"), 0);
  EXPECT_EQ(length(torus, "border"), 0);
}

TEST_F(SurfaceMeshTest, FormulasThatBeginWithAMinus) {
  const json sheet = drawn("--parametric -u -v -1 -u 0:1:2 -v 0:2:2 --view top");
  EXPECT_NEAR(length(sheet, "horizon"), 6, kMicrometre);
}

TEST_F(SurfaceMeshTest, EveryParametricSurfaceHasItsRanges) {
  const json sheets = drawn("--parametric u v 0 --parametric u v 0 -u 0:1:2 -u 3:4:2 -v 0:1:2 --view top");
  EXPECT_NEAR(length(sheets, "horizon"), 8, kMicrometre);
}

TEST_F(SurfaceMeshTest, TheHorizonAndTheMeshDrawTheSame) {
  for (const Words view : {"", "--azimuth 20 --elevation 50", "--eye 30,-20,25"}) {
    Words arguments = "5*sin(r)/r -x -9:9:60 -y -8:9:55 --z-scale 1" + view;
    const double horizon = layers(arguments).at("horizon");
    arguments += "--method appel";
    const auto mesh = layers(arguments);
    EXPECT_NEAR(mesh.at("horizon"), horizon, 0.02 * horizon);
    EXPECT_GT(mesh.at("outline"), 0);
    EXPECT_EQ(mesh.count("intersection") + mesh.count("mesh") + mesh.count("crease"), 0u);
  }
}

TEST_F(SurfaceMeshTest, HeightRangesEndInBorders) {
  const json bowl = drawn("x^2+y^2 -x -2:2:41 -y -2:2:41 --z-range 0:1 --z-scale 1 --view top");
  EXPECT_NEAR(length(bowl, "border"), 2 * std::numbers::pi, 0.01);
  double largest = 0;
  for (const json& stroke : bowl["strokes"]) {
    for (const json& end : stroke["source"]["ends"]) largest = std::max(largest, end[2].get<double>());
  }
  EXPECT_EQ(largest, 1);
}

TEST_F(SurfaceMeshTest, BlocksStandOnTheirBase) {
  // A flat block 4 wide, 2 deep, 1 high, seen from the front: its rim and its base, and the uprights.
  const json block = drawn("1 -x 0:4:5 -y 0:2:3 --z-scale 1 --skirt 0 --view front");
  EXPECT_NEAR(length(block, "border"), 2 * (4 + 1), kMicrometre);
  EXPECT_NEAR(length(block, "horizon"), 0, kMicrometre) << "all on the rim";
  const json open = drawn("1 -x 0:4:5 -y 0:2:3 --z-scale 1 --skirt --view front");
  EXPECT_NEAR(length(open, "horizon"), 4, kMicrometre) << "no range of heights, no depth of the base";
}

TEST_F(SurfaceMeshTest, HiddenLines) {
  const Words hill = "2*exp(-r^2) -x -3:3:20 -y -3:3:20 --elevation 20";
  EXPECT_EQ(layers(hill).count("hidden"), 0u);
  EXPECT_GT(layers(hill + "--hidden dashed").at("hidden"), 10);
}

TEST_F(SurfaceMeshTest, GridsAndFormulasTogether) {
  write("hill.csv", "0,0,0,0\n0,3,3,0\n0,3,3,0\n0,0,0,0\n");
  // The level of 1.5 takes the ground of the grid; its line on the hill is an octagon, of which the ground shows nothing.
  const json lake = drawn("--grid hill.csv 1.5 --z-scale 1 --view top");
  EXPECT_GT(length(lake, "intersection"), 6);
  const json window = drawn("--grid hill.csv -x 1:2 -y 0.5:3 --view top");
  EXPECT_NEAR(length(window, "horizon"), 2 * 2 + 3 * 1, kMicrometre);
}

TEST_F(SurfaceMeshTest, Logarithms) {
  const json heights = drawn("10^x -x 0:2:3 -y 0:1:2 --log-z --z-scale 1");
  for (const json& stroke : heights["strokes"]) {
    for (const json& end : stroke["source"]["ends"]) EXPECT_NEAR(end[2].get<double>(), end[0].get<double>(), 1e-12);
  }
  EXPECT_GT(layers("x --log-z -x -1:1:20").at("horizon"), 0) << "by the horizon, too; half of it are holes";
}

TEST_F(SurfaceMeshTest, MeshFiles) {
  for (const std::string name : {"hill.json", "hill.obj"}) {
    const Outcome outcome = surface("x*y -x 0:1:3 -y 0:1:3 --samples 5 --z-scale 2 --as-mesh", {"-o", name});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const Outcome info = run_well({"info", name, "--json"});
    EXPECT_EQ(json::parse(info.out)["scene"]["faces"], 32) << info.out;
    run_well({"draw", name, "--edges", "all", "-o", "hill.svg"});
  }
  fails("x --as-mesh -o a.svg", 2, "--output: a.svg does not end in .json or .obj");
  fails("x --as-mesh -o - --format svg", 2, "--format: ");
  fails("sqrt(-1-r) --as-mesh -o a.obj", 1, "surface: sqrt(-1-r) has no value");
}

TEST_F(SurfaceMeshTest, MeshesOverDegreesAreNoThingsInSpace) {
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

TEST_F(SurfaceMeshTest, TheSameBytesWithAnyNumberOfThreads) {
  const Words bowls = "x^2+y^2 8-x^2-y^2 -x -3:3 -y -3:3 --hidden dashed --z-range 0:7";
  const auto with = [&](const char* threads) {
    return surface(bowls, {"--threads", threads, "-o", "-", "--format", "json"}).out;
  };
  EXPECT_EQ(with("1"), with("4"));
}

TEST_F(SurfaceMeshTest, Mistakes) {
  write("flat.csv", "1,1,1\n1,1,1\n1,1,1\n");
  fails("x --method newton -o a.svg", 2, "--method: \"newton\" is not one of auto, horizon");
  fails("x y --method horizon -o a.svg", 2, "--method: horizon can not draw several surfaces");
  fails("x --method horizon --hidden solid -o a.svg", 2, "--method: horizon can not draw --hidden");
  fails("x --method appel --horizon pixels -o a.svg", 2, "--horizon pixels: ");
  fails("x --z-range 3:1 -o a.svg", 2, "--z-range: the range 3:1 does not ascend");
  fails("x --z-range 1:3:4 -o a.svg", 2, "--z-range: \"1:3:4\" is not A:B");
  fails("x --z-range 1:1/0 -o a.svg", 2, "--z-range: \"1/0\" is not a finite number");
  fails("x --skirt 0 -o a.svg", 2, "--skirt: 0 is above the lowest height, -5");
  fails("x --skirt deep -o a.svg", 2, "--skirt: ");
  fails("--parametric u v -o a.svg", 2, "--output: there is no output file");
  fails("--parametric u v", 2, "--parametric: its value is missing");
  fails("--parametric u v w -o a.svg", 1, "formula of z:1: unknown name 'w'");
  fails("--parametric u v 0 -x 0:1 -o a.svg", 2, "-x, -y: work for z = f(x, y) only");
  fails("--parametric u v 0 --skirt -o a.svg", 2, "--skirt: works for z = f(x, y), which");
  fails("--parametric u v 0 -u 0:1:1 -o a.svg", 2, "-u: ");
  fails("--parametric u v 0 -u 1:1 -o a.svg", 2, "-u: the range 1:1 does not ascend");
  fails("--parametric u v 0 -v 0:q -o a.svg", 2, "-v: \"q\":1: unknown name 'q'");
  fails("x -u 0:1 -o a.svg", 2, "-u, -v: need --parametric");
  for (const char* n : {"0", "1", "1000000000"}) fails({"x", "y", "-x", std::string("0:1:") + n, "-o", "a.svg"}, 2, "-x: ");
  fails("x -x 0:1:20000 -y 0:1:20000 --method appel -o a.svg", 1, "x: 20000 x 20000 samples are too many for a mesh");
  fails("--grid flat.csv -x 0:1:4 -o a.svg", 2, "-x, -y: a grid takes A:B");
  fails("--grid flat.csv -x 7:9 -o a.svg", 1, "flat.csv: the window -x, -y holds 0 columns");
  fails("--grid flat.csv --samples 9 -o a.svg", 2, "--samples: ");
  fails("x --z-range 30:40 -o a.svg", 1, "surface: x has no height within --z-range");
  fails("10^(100*x) --method appel --z-scale 1 -o a.svg", 1, "surface: has a coordinate beyond 1.6e60");
  fails("x y --output a.gif", 2, "--output: ");
}

TEST_F(SurfaceMeshTest, HatchedSurfaces) {
  const auto hatched = [&](const Words& more) {
    return run("surface x*y/5 -x -5:5:9 -y -5:5:9 -o - --format svg --hatch shade" + more);
  };
  const Outcome plain = hatched({});
  EXPECT_EQ(plain.status, 0) << plain.err;
  expect_parts(plain.out, {"id=\"hatch\"", "id=\"horizon\""});
  EXPECT_EQ(hatched("--lines none").out.find("id=\"horizon\""), std::string::npos);
  EXPECT_EQ(
      hatched("--method horizon")
          .err.rfind(
              "ligne: --hatch: method horizon gives neither regions nor spans; regions: atherton-weiler, warnock, newell, "
              "bsp, convex-tree; spans: watkins",
              0),
      0u);
  EXPECT_EQ(run("surface x --hatch shade --as-mesh -o x.obj").status, 2);
}

}  // namespace
}  // namespace ligne::test
