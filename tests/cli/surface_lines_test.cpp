/// Contour lines and axes of `ligne surface` by the mesh methods.

#include <numbers>

#include "surface_program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class SurfaceLinesTest : public SurfaceProgramTest {
 protected:
  std::string svg(std::vector<std::string> arguments, const std::vector<std::string>& more = {}) const {
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = surface(arguments, {"-o", "-", "--format", "svg"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  std::map<std::string, double> layers_with(std::vector<std::string> arguments, const std::vector<std::string>& more) const {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return layers(arguments);
  }
};

/// How many texts say this.
std::size_t texts(const std::string& svg, const std::string& text) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = svg.find(">" + text + "</text>", at)) != std::string::npos; ++at) ++n;
  return n;
}

TEST_F(SurfaceLinesTest, TheHorizonAndTheMeshDrawTheSameContours) {
  const std::vector<std::vector<std::string>> surfaces{
      {"5*sin(r)/r", "-x", "-9:9:60", "-y", "-8:9:55", "--contours", "12"},
      {"sin(x)*cos(y/2)", "-x", "-5:5:30", "-y", "-5:5:30", "--contour-step", "0.1", "--lines", "x"},
      {"if(abs(x-1)+abs(y) < 1.5, sqrt(-1), x^2-y^2)", "-x", "-4:4:23", "-y", "-4:4:29", "--contour-step", "0.7"},
      {"x+y", "-x", "-4:4:9", "-y", "-4:4:9", "--samples", "9", "--contour-step", "1"},  // along the diagonals of the cells
      {"x-y", "-x", "-4:4:9", "-y", "-4:4:9", "--samples", "9", "--contour-step", "1"},  // through their corners
  };
  for (const auto& arguments : surfaces) {
    // Without outlines: a mesh draws a contour that runs along one, or within the breadth of a coincidence beside it, as
    // outline alone.
    for (const std::vector<std::string>& view :
         {std::vector<std::string>{}, {"--azimuth", "20", "--elevation", "50"}, {"--eye", "30,-20,25", "--z-scale", "1"}}) {
      std::vector<std::string> by_horizon = arguments;
      by_horizon.insert(by_horizon.end(), {"--outline", "off"});
      std::vector<std::string> by_mesh = by_horizon;
      by_mesh.insert(by_mesh.end(), {"--method", "appel"});
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
      const std::vector<std::string> slope{formula,          "-x",  "-3:3:14",   "-y",    "-3:3:10",     "--outline", "off",
                                           "--contour-step", "0.7", "--azimuth", azimuth, "--elevation", "70"};
      const double horizon = layers(slope).at("contour");
      EXPECT_GT(horizon, 500) << formula;
      EXPECT_NEAR(layers_with(slope, {"--method", "appel"}).at("contour"), horizon, 1e-4 * horizon)
          << formula << " from " << azimuth;
    }
  }
  // On the plane they are seen where the surface above, 10 of them, is out of the way: from below all of them.
  const auto below = layers({"x", "-x", "0:1:3", "-y", "0:1:3", "--z-scale", "1", "--contours-base", "-1", "--azimuth", "90",
                             "--elevation", "-60", "--scale", "100:1"});
  EXPECT_NEAR(below.at("contour-base"), 10 * 100 * std::sin(std::numbers::pi / 3), 0.01);
}

TEST_F(SurfaceLinesTest, TheSurfaceBelowTheEyeHidesTheAxes) {
  // The eye is over the surface, within the box: the ground below is hidden.
  const std::vector<std::string> saddle{"x^2-0.31*y^2+1.62",
                                        "-x",
                                        "-3:3:21",
                                        "-y",
                                        "-3:3:18",
                                        "--z-scale",
                                        "1",
                                        "--eye",
                                        "-1.6,-1.8,5.5",
                                        "--fov",
                                        "70",
                                        "--lines",
                                        "none",
                                        "--outline",
                                        "off",
                                        "--contours",
                                        "8"};
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
  const std::vector<std::string> cone{
      "r", "-x",        "-3.5:3.5:71", "-y",     "-3.5:3.5:71", "--z-range", "0:3.5", "--contour-step",
      "1", "--z-scale", "1",           "--view", "top"};
  EXPECT_NEAR(length(drawn(cone), "contour"), 2 * std::numbers::pi * (1 + 2 + 3), 0.01);
  std::vector<std::string> alone = cone;
  alone.insert(alone.end(), {"--lines", "none", "--outline", "off"});
  const json drawing = drawn(alone);
  EXPECT_NEAR(length(drawing, "contour"), length(drawn(cone), "contour"), kMicrometre);
  EXPECT_EQ(length(drawing, "border") + length(drawing, "outline") + length(drawing, "horizon"), 0);
}

TEST_F(SurfaceLinesTest, ContoursAlongTheEdgesOfTheMesh) {
  // The level 1 is a row of samples; the level 2, the upper rim, is a border.
  const std::vector<std::string> slope{"y", "-x",     "0:3:2", "-y",      "0:2:3", "--samples",      "3", "--z-scale",
                                       "1", "--view", "top",   "--lines", "x",     "--contour-step", "1"};
  const json drawing = drawn(slope);
  EXPECT_NEAR(length(drawing, "contour"), 3, kMicrometre);
  EXPECT_NEAR(length(drawing, "border"), 2 * 3, kMicrometre);
}

TEST_F(SurfaceLinesTest, ContoursOfEverySurface) {
  const json bowls = drawn({"x^2+y^2", "8-x^2-y^2", "-x", "-3:3:61", "-y", "-3:3:61", "--z-range", "0:8", "--contour-step",
                            "2", "--z-scale", "1", "--view", "top"});
  // From above the upper bowl hides the lower one inside r = 2; the levels 6 and 4 are r^2 = 2 and 4 on it, the last of
  // which is the crossing.
  EXPECT_NEAR(length(bowls, "contour"), 2 * std::numbers::pi * (std::sqrt(2.0) + std::sqrt(6.0)), 0.1);
  const json torus = drawn({"--parametric", "(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)", "-u", "0:2*pi:61", "-v",
                            "0:2*pi:61", "--contour-step", "0.5", "--view", "top"});
  EXPECT_NEAR(length(torus, "contour"), 2 * std::numbers::pi * (4 + 2 + 2 * 3 + 3), 0.1)
      << "at 0 the equators, at 0.5 two circles of mean radius 3, and the top";
}

TEST_F(SurfaceLinesTest, HiddenContoursAndBlocks) {
  const std::vector<std::string> hill{"2*exp(-r^2)", "-x", "-3:3:20",     "-y", "-3:3:20",
                                      "--contours",  "5",  "--elevation", "20"};
  const auto seen = layers(hill), block = layers_with(hill, {"--skirt"}), hidden = layers_with(hill, {"--hidden", "dashed"});
  EXPECT_NEAR(hidden.at("contour"), seen.at("contour"), 1e-4 * seen.at("contour"));
  EXPECT_GT(hidden.at("hidden"), 10);
  EXPECT_GT(block.at("contour"), 100);
}

TEST_F(SurfaceLinesTest, AxesOfTheMeshAreThoseOfTheHorizon) {
  for (const char* style : {"--axes", "--axes=grid", "--axes=box", "--axes=base"}) {
    for (const std::vector<std::string>& view :
         {std::vector<std::string>{}, {"--azimuth", "20", "--elevation", "-35"}, {"--eye", "30,-20,25"}}) {
      std::vector<std::string> plot{"5*sin(r)/r", "-x", "-9:9:30", "-y",      "-8:9:30",
                                    "--z-scale",  "1",  style,     "--title", "hat"};
      plot.insert(plot.end(), view.begin(), view.end());
      const std::string by_horizon = svg(plot);
      const double horizon = layers(plot).at("axes");
      const double mesh = layers_with(plot, {"--method", "appel"}).at("axes");
      EXPECT_NEAR(mesh, horizon, 1e-3 * horizon) << style;
      const std::string by_mesh = svg(plot, {"--method", "appel"});
      EXPECT_EQ(by_mesh.substr(by_mesh.find("id=\"text\"")), by_horizon.substr(by_horizon.find("id=\"text\""))) << style;
    }
  }
}

TEST_F(SurfaceLinesTest, AxesMeasureWhatIsDrawn) {
  const std::string torus = svg({"--parametric", "(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)", "-u", "0:2*pi:41", "-v",
                                 "0:2*pi:41", "--axes", "--title", "torus"});
  EXPECT_EQ(texts(torus, "torus"), 1u);
  EXPECT_EQ(texts(torus, "\u22124"), 2u) << "x and y from -4 to 4";
  EXPECT_EQ(texts(torus, "0.5"), 1u) << "z from -1 to 1";
  const std::string cut = svg({"tan(x*y)", "-x", "-2:2", "-y", "-2:2", "--z-range", "-30:30", "--axes"});
  EXPECT_EQ(texts(cut, "\u221220"), 1u) << "z from -30 to 30";
  EXPECT_EQ(texts(cut, "40"), 0u);
  const std::vector<std::string> slope{"50+x", "-x", "0:10", "-y", "0:10", "--z-scale", "0.2", "--axes"};
  EXPECT_EQ(texts(svg(slope), "20"), 0u);
  EXPECT_EQ(texts(svg(slope, {"--skirt", "0"}), "20"), 1u) << "the base is part of the box";
}

TEST_F(SurfaceLinesTest, HiddenPartsOfAxesAreNotDrawn) {
  const std::vector<std::string> slope{"y",       "-x",    "0:1:5",  "-y",        "0:1:5", "--z-scale",   "1",
                                       "--scale", "100:1", "--axes", "--azimuth", "-90",   "--elevation", "20"};
  const auto plain = layers_with(slope, {"--method", "appel"}), dashed = layers_with(slope, {"--hidden", "dashed"});
  EXPECT_NEAR(dashed.at("axes"), plain.at("axes"), kMicrometre);
  EXPECT_EQ(dashed.count("hidden"), 0u) << "but for the axes nothing is hidden";
}

TEST_F(SurfaceLinesTest, MistakesOfEngines) {
  fails({"x", "--skirt", "--contours-base", "-o", "a.svg"}, 2,
        "--contours-base: is drawn by the method horizon alone, and does not go with --skirt");
  fails({"x", "y", "--underside", "apart", "-o", "a.svg"}, 2,
        "--underside: is drawn by the method horizon alone, and does not go with several surfaces");
  fails({"x", "--z-range", "0:1", "--ridgeline", "-o", "a.svg"}, 2,
        "--ridgeline: is drawn by the method horizon alone, and does not go with --z-range");
  fails({"x", "--method", "appel", "--hidden-by", "curves", "-o", "a.svg"}, 2,
        "--hidden-by curves: is drawn by the method horizon alone, and does not go with --method appel");
  fails({"x", "--hidden", "solid", "--horizon", "pixels", "-o", "a.svg"}, 2,
        "--horizon pixels: is drawn by the method horizon alone, and does not go with --hidden");
  fails({"x", "--contours", "3", "--as-mesh", "-o", "a.obj"}, 2, "--contours: ");
  fails({"x", "--axes", "--as-mesh", "-o", "a.obj"}, 2, "--axes: ");
  fails({"x", "--axes", "-o", "a.json"}, 2, "--axes: are not written as json");
  fails({"x", "y", "--contour-step", "1e-9", "-o", "a.svg"}, 2, "--contour-step: gives more than 10000 contour lines");
}

}  // namespace
}  // namespace ligne::test
