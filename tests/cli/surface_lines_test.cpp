/// Contour lines and axes of `ligne surface` by the mesh methods.

#include <chrono>
#include <numbers>

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

/// How many texts say this.
std::size_t texts(const std::string& svg, const std::string& text) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = svg.find(">" + text + "</text>", at)) != std::string::npos; ++at) ++n;
  return n;
}

TEST_F(SurfaceLinesTest, TheHorizonAndTheMeshDrawTheSameContours) {
  const std::vector<Words> surfaces{
      {"5*sin(r)/r", "-x", "-9:9:60", "-y", "-8:9:55", "--contours", "12"},
      {"sin(x)*cos(y/2)", "-x", "-5:5:30", "-y", "-5:5:30", "--contour-step", "0.1", "--lines", "x"},
      {"if(abs(x-1)+abs(y) < 1.5, sqrt(-1), x^2-y^2)", "-x", "-4:4:23", "-y", "-4:4:29", "--contour-step", "0.7"},
      {"x+y", "-x", "-4:4:9", "-y", "-4:4:9", "--samples", "9", "--contour-step", "1"},  // along the diagonals of the cells
      {"x-y", "-x", "-4:4:9", "-y", "-4:4:9", "--samples", "9", "--contour-step", "1"},  // through their corners
  };
  for (const auto& arguments : surfaces) {
    // Without outlines: a mesh draws a contour that runs along one, or within the breadth of a coincidence beside it, as
    // outline alone.
    for (const Words view :
         chosen("contours, " + arguments[0], 3, {"", "--azimuth 20 --elevation 50", "--eye 30,-20,25 --z-scale 1"})) {
      Words by_horizon = arguments + "--outline off";
      Words by_mesh = by_horizon + "--method appel";
      const double horizon = layers_with(by_horizon, view).at("contour");
      EXPECT_GT(horizon, 100);
      EXPECT_NEAR(layers_with(by_mesh, view).at("contour"), horizon, 1e-5 * horizon)
          << arguments[0] << (view.empty() ? "" : view[0]);
    }
  }
}

TEST_F(SurfaceLinesTest, ContoursAlongTheSights) {
  // Seen along the y axis contours that run along it are upright.
  for (const char* formula : {"2.83*x+1.75*round(y)", "2*x", "x*x"}) {
    for (const char* azimuth : {"90", "-90"}) {
      const Words slope{formula,          "-x",  "-3:3:14",   "-y",    "-3:3:10",     "--outline", "off",
                        "--contour-step", "0.7", "--azimuth", azimuth, "--elevation", "70"};
      const double horizon = layers(slope).at("contour");
      EXPECT_GT(horizon, 500) << formula;
      EXPECT_NEAR(layers_with(slope, "--method appel").at("contour"), horizon, 1e-4 * horizon)
          << formula << " from " << azimuth;
    }
  }
  // On the plane they are seen where the surface above, 9 of them, is out of the way: from below all of them.
  const auto below = layers("x -x 0:1:3 -y 0:1:3 --z-scale 1 --contours-base -1 --azimuth 90 --elevation -60 --scale 100:1");
  EXPECT_NEAR(below.at("contour-base"), 9 * 100 * std::sin(std::numbers::pi / 3), 0.01);
}

TEST_F(SurfaceLinesTest, TheSurfaceBelowTheEyeHidesTheAxes) {
  // The eye is over the surface, within the box: the ground below is hidden.
  const Words saddle =
      "x^2-0.31*y^2+1.62 -x -3:3:21 -y -3:3:18 --z-scale 1 --eye -1.6,-1.8,5.5 --fov 70 --lines none "
      "--outline off --contours 8";
  for (const char* style : {"--axes=base", "--axes=back"}) {
    const auto horizon = layers_with(saddle, {style, "--contours-base"});
    const auto mesh = layers_with(saddle, {style, "--method", "appel"});
    const auto of = [](const std::map<std::string, double>& layers, const char* name) {
      return layers.count(name) ? layers.at(name) : 0.0;
    };
    EXPECT_LT(of(horizon, "axes"), 0.1) << style;
    EXPECT_LT(of(mesh, "axes"), 0.1) << style;
    EXPECT_LT(of(horizon, "contour-base"), 0.1) << style;
  }
}

TEST_F(SurfaceLinesTest, ContoursOfACone) {
  // Seen from above: circles of radius 1, 2 and 3, but for the polygons that stand for them.
  const Words cone = "r -x -3.5:3.5:71 -y -3.5:3.5:71 --z-range 0:3.5 --contour-step 1 --z-scale 1 --view top";
  const double all = length(drawn(cone), "contour");
  EXPECT_NEAR(all, 2 * std::numbers::pi * (1 + 2 + 3), 0.01);
  const json drawing = drawn(cone + "--lines none --outline off");
  EXPECT_NEAR(length(drawing, "contour"), all, kMicrometre);
  EXPECT_EQ(length(drawing, "border") + length(drawing, "outline") + length(drawing, "horizon"), 0);
}

TEST_F(SurfaceLinesTest, ContoursAlongTheEdgesOfTheMesh) {
  // The level 1 is a row of samples; the level 2, the upper rim, is a border.
  const json drawing = drawn("y -x 0:3:2 -y 0:2:3 --samples 3 --z-scale 1 --view top --lines x --contour-step 1");
  EXPECT_NEAR(length(drawing, "contour"), 3, kMicrometre);
  EXPECT_NEAR(length(drawing, "border"), 2 * 3, kMicrometre);
}

TEST_F(SurfaceLinesTest, ContoursOfEverySurface) {
  const json bowls = drawn("x^2+y^2 8-x^2-y^2 -x -3:3:61 -y -3:3:61 --z-range 0:8 --contour-step 2 --z-scale 1 --view top");
  // From above the upper bowl hides the lower one inside r = 2; the levels 6 and 4 are r^2 = 2 and 4 on it, the last of
  // which is the crossing.
  EXPECT_NEAR(length(bowls, "contour"), 2 * std::numbers::pi * (std::sqrt(2.0) + std::sqrt(6.0)), 0.1);
  const json torus = drawn(
      "--parametric (3+cos(v))*cos(u) (3+cos(v))*sin(u) sin(v) -u 0:2*pi:61 -v 0:2*pi:61 --contour-step "
      "0.5 --view top");
  EXPECT_NEAR(length(torus, "contour"), 2 * std::numbers::pi * (4 + 2 + 2 * 3 + 3), 0.1)
      << "at 0 the equators, at 0.5 two circles of mean radius 3, and the top";
}

TEST_F(SurfaceLinesTest, HiddenContoursAndBlocks) {
  const Words hill = "2*exp(-r^2) -x -3:3:20 -y -3:3:20 --contours 5 --elevation 20";
  const auto seen = layers(hill), block = layers_with(hill, "--skirt"), hidden = layers_with(hill, "--hidden dashed");
  EXPECT_NEAR(hidden.at("contour"), seen.at("contour"), 1e-4 * seen.at("contour"));
  EXPECT_GT(hidden.at("hidden"), 10);
  EXPECT_GT(block.at("contour"), 100);
}

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

TEST_F(SurfaceLinesTest, AxesMeasureWhatIsDrawn) {
  const std::string torus =
      svg("--parametric (3+cos(v))*cos(u) (3+cos(v))*sin(u) sin(v) -u 0:2*pi:41 -v 0:2*pi:41 --axes --title "
          "torus");
  EXPECT_EQ(texts(torus, "torus"), 1u);
  EXPECT_EQ(texts(torus, "\u22124"), 2u) << "x and y from -4 to 4";
  EXPECT_EQ(texts(torus, "0.5"), 1u) << "z from -1 to 1";
  const std::string cut = svg("tan(x*y) -x -2:2 -y -2:2 --z-range -30:30 --axes");
  EXPECT_EQ(texts(cut, "\u221220"), 1u) << "z from -30 to 30";
  EXPECT_EQ(texts(cut, "40"), 0u);
  const Words slope = "50+x -x 0:10 -y 0:10 --z-scale 0.2 --axes";
  EXPECT_EQ(texts(svg(slope), "20"), 0u);
  EXPECT_EQ(texts(svg(slope, "--skirt 0"), "20"), 1u) << "the base is part of the box";
}

TEST_F(SurfaceLinesTest, HiddenPartsOfAxesAreNotDrawn) {
  const Words slope = "y -x 0:1:5 -y 0:1:5 --z-scale 1 --scale 100:1 --axes --azimuth -90 --elevation 20";
  const auto plain = layers_with(slope, "--method appel"), dashed = layers_with(slope, "--hidden dashed");
  EXPECT_NEAR(dashed.at("axes"), plain.at("axes"), kMicrometre);
  EXPECT_EQ(dashed.count("hidden"), 0u) << "but for the axes nothing is hidden";
}

TEST_F(SurfaceLinesTest, MistakesOfEngines) {
  fails("x --skirt --contours-base -o a.svg", 2,
        "--contours-base: is drawn by method horizon only, and can not be combined with --skirt");
  fails("x y --underside apart -o a.svg", 2,
        "--underside: is drawn by method horizon only, and can not be combined with several surfaces");
  fails("x --z-range 0:1 --ridgeline -o a.svg", 2,
        "--ridgeline: is drawn by method horizon only, and can not be combined with --z-range");
  fails("x --method appel --hidden-by curves -o a.svg", 2,
        "--hidden-by curves: is drawn by method horizon only, and can not be combined with --method appel");
  fails("x --hidden solid --horizon pixels -o a.svg", 2,
        "--horizon pixels: is drawn by method horizon only, and can not be combined with --hidden");
  fails("x --contours 3 --as-mesh -o a.obj", 2, "--contours: ");
  fails("x --axes --as-mesh -o a.obj", 2, "--axes: ");
  fails("x --axes -o a.json", 2, "--axes: are not written as json");
  fails("x y --contour-step 1e-9 -o a.svg", 2, "--contour-step: gives more than 10000 contour lines");
}

/// Bad input of `ligne surface`: one line, the exit status and no file, or a right drawing of what there is.

class SurfaceInputTest : public SurfaceProgramTest {
 protected:
  /// By the horizon and by a mesh: the line, and no file beside those of the test.
  void refuses(const Words& source, int status, const std::string& message) const {
    const std::vector<std::string> files = new_files();
    for (const Words method : {"", "--method appel", {"--skirt"}, "--contours 5 --axes"}) {
      Words arguments = source + method + "-o out.svg";
      fails(arguments, status, message);
      EXPECT_EQ(new_files(), files) << message;
    }
  }
  /// Length of a layer as seen from above, by a mesh method.
  double from_above(const std::string& formula, const std::string& layer, const Words& more = {}) const {
    return length(drawn(Words{formula, "-x", "-2:2:5", "-y", "-2:2:5", "--samples", "5", "--view", "top", "--z-scale", "1",
                              "--method", "appel"} +
                        more),
                  layer);
  }
};

TEST_F(SurfaceInputTest, FormulasThatHaveNoValueInPlaces) {
  // Cut at 1 and -1: two strips 1 wide are left, of two curves with 5 curves across.
  EXPECT_NEAR(from_above("1/x", "horizon", "--z-range -1:1"), 2 * (2 * 4 + 5 * 1), kMicrometre);
  EXPECT_NEAR(from_above("1/x", "border", "--z-range -1:1"), 0, kMicrometre) << "all rims are curves";
  EXPECT_NEAR(from_above("1/x", "border", "--lines x --z-range -1:1"), 4, kMicrometre) << "the rims across";
  EXPECT_NEAR(from_above("sqrt(x)", "horizon"), 3 * 4 + 5 * 2, kMicrometre) << "x from 0 to 2";
  EXPECT_NEAR(from_above("log(x)", "horizon", "--z-range 0:1"), 2 * 4 + 5 * 1, kMicrometre) << "x from 1 to 2";
}

TEST_F(SurfaceInputTest, TheHorizonLeavesOutWholeCells) {
  for (const char* formula : {"sqrt(x-0.1)", "asin(r/2.1)", "if(x < 0.1, sqrt(-1), y)", "floor(x+y)+x"}) {
    const Words plot{formula, "-x", "-2:2:17", "-y", "-2:2:17", "--samples", "17", "--view", "top", "--scale", "10:1"};
    Words horizon = plot + "--method horizon";
    const double seen = layers(horizon).at("horizon"), mesh = layers(plot).at("horizon");
    EXPECT_GT(seen, 10) << formula;
    EXPECT_LT(seen, mesh) << formula;
    EXPECT_GT(seen, 0.5 * mesh) << formula;
  }
}

TEST_F(SurfaceInputTest, FormulasWithoutAnyValue) {
  for (const char* formula : {"log(-1-r)", "0/0", "x/0", "1e308*10*x"}) {
    for (const char* more :
         {"--skirt", "--contours=3", "--axes", "--contours-base", "--ridgeline", "--lines=x", "--hidden=dashed"}) {
      fails({formula, more, "-o", "out.svg"}, 1, std::string("surface: ") + formula + " has no value");
    }
  }
  fails("log(-1-r) x -o out.svg", 0, "surface: warning: log(-1-r) has no value");
}

TEST_F(SurfaceInputTest, Ranges) {
  refuses("x -x 1:1", 2, "-x: the range 1:1 does not ascend");
  refuses("x -y 2:-2", 2, "-y: the range 2:-2 does not ascend");
  refuses("x -x 0:1/0", 2, "-x: \"1/0\" is not a finite number");
  refuses("x -x 0:sqrt(-1)", 2, "-x: \"sqrt(-1)\" is not a finite number");
  refuses("x -x -1.7e308:1.7e308", 2, "-x: the range -1.7e308:1.7e308 is too large");
  refuses("x -x :", 2, "-x: ");
  refuses("x -x 1:2:3:4", 2, "-x: ");
  for (const char* n : {"0", "1", "-3", "2.5", "1000000000", "99999999999999999999"}) {
    refuses({"x", "-x", std::string("0:1:") + n}, 2, "-x: ");
    refuses({"x", "--samples", n}, 2, "--samples: ");
  }
  for (const char* n : {"0", "-1", "1.5", "1000000000"}) refuses({"x", "--contours", n}, 2, "--contours");
  for (const char* step : {"0", "-1", "nan", "inf"}) refuses({"x", "--contour-step", step}, 2, "--contour-step: ");
}

TEST_F(SurfaceInputTest, Grids) {
  const std::string esri_end = "xllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9\n";
  write("short.csv", "1,2,3\n4,5\n6,7,8\n");
  write("words.csv", "1,2\nx,4\n");
  write("prose.txt", "heights of hills\nwritten by hand\n");
  write("column.csv", "1\n2\n3\n");
  write("row.csv", "1,2,3\n");
  write("nan.txt", "nan nan\nnan nan\n");
  write("empty.csv", "");
  write("blank.csv", "\n\n\n");
  write("nodata.asc", "ncols 2\nnrows 2\n" + esri_end + "-9 -9\n-9 -9\n");
  write("wide.asc", "ncols 4294967296\nnrows 2\n" + esri_end + "1 2\n");
  write("tall.asc", "ncols 2\nnrows 4294967296\n" + esri_end + "1 2\n");
  write("both.asc", "ncols 4000000000\nnrows 4000000000\n" + esri_end + "1 2\n");
  write("early.asc", "ncols 2\nnrows 3\n" + esri_end + "1 2\n3 4\n5");
  write("big.pgm", "P5 4000000000 4000000000 255\n");
  write("noise.bin", std::string("\x01\x02\0\x03", 4));
  std::filesystem::create_directory(file("folder"));
  refuses("--grid short.csv", 1, "short.csv:2: row of 2 columns; those above have 3\n");
  refuses("--grid words.csv", 1, "words.csv:2: column 1: 'x' is not a number\n");
  refuses("--grid prose.txt", 1, "prose.txt:1: column 1: 'heights' is not a number");
  refuses("--grid column.csv", 1, "column.csv: has 1 column and 3 rows; a grid has two of each or more\n");
  refuses("--grid row.csv", 1, "row.csv: has 3 columns and 1 row; a grid has two of each or more\n");
  refuses("--grid nan.txt", 1, "nan.txt: contains only NODATA values\n");
  refuses("--grid nodata.asc", 1, "nodata.asc: contains only NODATA values\n");
  refuses("--grid empty.csv", 1, "empty.csv: is empty\n");
  refuses("--grid blank.csv", 1, "blank.csv: holds no row of numbers\n");
  refuses("--grid wide.asc", 1, "wide.asc:1: ncols '4294967296' is more than a file of ");
  refuses("--grid tall.asc", 1, "tall.asc:2: nrows '4294967296' is more than a file of ");
  refuses("--grid both.asc", 1, "both.asc:1: ncols '4000000000' is more than a file of ");
  refuses("--grid early.asc", 1, "early.asc");
  refuses("--grid big.pgm", 1, "big.pgm:1: width 4000000000 is not between 1 and ");
  refuses("--grid noise.bin", 1, "noise.bin: is not a known grid format");
  refuses("--grid folder", 1, "folder: is a directory, not a file\n");
  refuses("--grid nowhere.csv", 1, "nowhere.csv: ");
  refuses("--grid ''", 1, "");
}

TEST_F(SurfaceInputTest, ContoursWithoutNumberOrMemory) {
  // Ten thousand levels on a steep sheet of two million triangles would cut it into thousands of millions.
  const auto begin = std::chrono::steady_clock::now();
  fails("sin(50*x)*sin(50*y) -x 0:1:500 -y 0:1:500 --samples 1000 --contours 10000 --skirt -o out.svg", 1,
        "sin(50*x)*sin(50*y): has too many contour lines: they cut it into more than 12 million triangles\n");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_FALSE(exists("out.svg"));
}

}  // namespace
}  // namespace ligne::test
