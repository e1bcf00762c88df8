/// The command `ligne surface`.

#include <cmath>
#include <regex>

#include "program.hpp"

namespace ligne::test {
namespace {

class SurfaceTest : public ProgramTest {
 protected:
  std::string svg(const Words& arguments) const {
    const Outcome outcome = run_well("surface" + arguments + "-o - --format svg");
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }
  /// Number of polylines in a layer.
  std::size_t paths(const Words& arguments, const std::string& layer = "horizon") const {
    const std::string text = svg(arguments);
    const std::size_t from = text.find("id=\"" + layer + "\""), to = text.find("</g>", from);
    std::size_t n = 0;
    if (from == std::string::npos) return n;
    for (std::size_t at = from; (at = text.find("<path", at)) < to; ++at) ++n;
    return n;
  }
  void fails(const Words& arguments, int status, const std::string& message) const {
    const Outcome outcome = run("surface" + arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("ligne: " + message, 0), 0u) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }
};

TEST_F(SurfaceTest, DrawsAFormulaInTheLayerHorizon) {
  const std::string text = svg("x*y -x 0:1:5 -y 0:1:7");
  expect_parts(text, {"id=\"horizon\""});
}

TEST_F(SurfaceTest, NumbersOfCurves) {
  const Words flat = "0 -x 0:1:5 -y 0:2:7";
  const auto with = [&](const Words& more) { return paths(flat + more); };
  EXPECT_EQ(with({}), 12u);
  EXPECT_EQ(with("--lines x"), 5u);
  EXPECT_EQ(with("--lines y"), 7u);
  EXPECT_EQ(with("--samples 100"), 12u);
  EXPECT_EQ(with("--eye 0.3,0.7,4 --fov 90"), 12u + 5 + 7) << "the eye over the ground divides the curves";
}

TEST_F(SurfaceTest, TheDefaultRangeIsWhereThereAreHeights) {
  const auto same = [&](const Words& formulas, const Words& ranges) { return svg(formulas) == svg(formulas + ranges); };
  EXPECT_TRUE(same("sqrt(1-x^2-y^2)", "-x -1:1 -y -1:1"));
  EXPECT_TRUE(same("sqrt(2-(x-1)^2-y^2)", "-x -0.5:2.5 -y -1.5:1.5")) << "in hundredths, outwards";
  EXPECT_TRUE(same("sqrt(x)", "-x 0:5 -y -5:5"));
  EXPECT_TRUE(same("sqrt(4-x^2-y^2) sqrt(1-x^2)-4", "-x -2:2 -y -5:5")) << "of either formula";
  EXPECT_TRUE(same("sqrt(x^2+y^2-9)", "-x -5:5 -y -5:5"));
  EXPECT_TRUE(same("'if(abs(x) < 0.06, y, 0/0)'", "-x -5:5 -y -5:5")) << "too narrow to tell";
  EXPECT_NE(svg("sqrt(1-x^2-y^2) -x -5:5"), svg("sqrt(1-x^2-y^2)")) << "a range that is given stays";
}

TEST_F(SurfaceTest, RimsAreDrawnUnlessACurveRunsThere) {
  const auto rims = [&](const Words& more) {
    Words flat = "0 -x 0:1:5 -y 0:2:7" + more;
    return paths(flat, "border");
  };
  EXPECT_EQ(rims({}), 0u);
  EXPECT_EQ(rims("--lines x"), 2u) << "those of constant y";
  EXPECT_EQ(rims("--lines y"), 2u) << "those of constant x";
  EXPECT_EQ(rims("--lines y --outline off"), 0u);
}

TEST_F(SurfaceTest, GridsAndTheirCurves) {
  write("flat.csv", "1,1,1,1,1\n1,1,1,1,1\n1,1,1,1,1\n1,1,1,1,1\n");
  EXPECT_EQ(paths("--grid flat.csv"), 9u);
  EXPECT_EQ(paths("--grid flat.csv --every 3"), 3u + 2u);  // columns 0, 3, 4 and rows 0, 3
}

TEST_F(SurfaceTest, HiddenPartsAreLeftOut) {
  // A wall before a plain, looked at from low in front: the plain behind it is not seen.
  const Words wall = "'min(1, max(0, 20*(0.25-y)))' -x 0:1:4 -y 0:1:5 --lines y --z-scale 1 --azimuth -90";
  const auto with = [&](const char* elevation) {
    Words all = wall + Words{"--elevation", elevation};
    return paths(all);
  };
  EXPECT_EQ(with("0"), 2u) << "the top of the wall, and the plain's level below it, once";
  EXPECT_EQ(with("80"), 4u) << "the wall hides 0.18 of the plain behind it, and there the curve at its foot";
  EXPECT_EQ(with("89"), 5u);
  Words all = wall + "--elevation 0";
  EXPECT_EQ(paths(all, "border"), 2u) << "upright, at the sides";
  EXPECT_EQ(paths(all, "outline"), 0u);
}

TEST_F(SurfaceTest, ThreadsAndHorizons) {
  const Words sombrero = "sin(r)/r -x -9:9:60 -y -9:9:60";
  const auto with = [&](const Words& more) { return svg(sombrero + more); };
  EXPECT_EQ(with("--threads 1"), with("--threads 4"));
  EXPECT_NE(with("--horizon pixels --resolution 300"), with({}));
}

TEST_F(SurfaceTest, AxesAreLayersOfTheirOwn) {
  const Words plot = "sin(r)/r -x -9:9 -y -9:9 --title 'a < b' --x-label east";
  const auto with = [&](const Words& more) { return svg(plot + more); };
  const std::string text = with("--axes");
  expect_parts(text, {"id=\"axes\"", "id=\"text\""});
  for (const char* label :
       {">a &lt; b</text>", ">east</text>", ">y</text>", ">z</text>", ">\u22124</text>", ">0.8</text>"}) {
    EXPECT_EQ(count_of(text, label), label == std::string(">\u22124</text>") ? 2u : 1u) << label;
  }
  const std::string strokes = with("--axes --text stroke");
  EXPECT_EQ(count_of(strokes, "<text"), 0u);
  EXPECT_EQ(count_of(strokes, "id=\"text\""), 1u);
  EXPECT_GT(count_of(with("--axes=grid"), "<path"), count_of(text, "<path"));
  EXPECT_EQ(count_of(with("--axes --y-label ''"), ">y</text>"), 0u) << "an empty name is none";
  EXPECT_EQ(with("--axes --threads 1"), with("--axes --threads 4"));
}

TEST_F(SurfaceTest, ATitleNeedsNoAxes) {
  const std::string text = svg("x*y --title saddle");
  EXPECT_EQ(count_of(text, "<title>saddle</title>"), 1u);
  EXPECT_EQ(count_of(text, ">saddle</text>"), 1u);
  EXPECT_EQ(count_of(text, "id=\"axes\""), 0u);
  EXPECT_EQ(count_of(svg("x*y"), "<text"), 0u);
}

/// Length in mm of all that a layer of an SVG holds.
double length_of_layer(const std::string& svg, const std::string& layer) {
  const std::size_t from = svg.find("id=\"" + layer + "\"");
  if (from == std::string::npos) return 0;
  const std::string text = svg.substr(from, svg.find("</g>", from) - from);
  double length = 0;
  const std::regex path("d=\"([^\"]*)\""), number("-?[0-9]*\\.?[0-9]+");
  for (std::sregex_iterator p(text.begin(), text.end(), path), end; p != end; ++p) {
    const std::string data = (*p)[1];
    const bool relative = data.find('l') != std::string::npos;
    std::vector<double> values;
    for (std::sregex_iterator n(data.begin(), data.end(), number); n != end; ++n) values.push_back(std::stod(n->str()));
    for (std::size_t i = 3; i < values.size(); i += 2) {
      length += relative ? std::hypot(values[i - 1], values[i])
                         : std::hypot(values[i - 1] - values[i - 3], values[i] - values[i - 2]);
    }
  }
  return length;
}

TEST_F(SurfaceTest, TheSurfaceHidesTheAxesBehindIt) {
  // A slope that rises away from the viewer hides the edge of the ground at the back, 100 mm long; with a hole in its middle
  // it does not.
  const auto length = [&](const std::string& formula) {
    return length_of_layer(svg({formula, "-x", "0:1:5", "-y", "0:1:5", "--z-scale", "1", "--scale", "100:1", "--axes",
                                "--azimuth", "-90", "--elevation", "20"}),
                           "axes");
  };
  const double hidden = length("y"), seen = length("if(abs(y-0.5) < 0.44, sqrt(-1), y)");
  EXPECT_LT(hidden, 100)
      << "ticks alone: the edges that are not hidden lie along the surface, whose own lines are there already";
  EXPECT_GE(seen - hidden, 100 - 0.01);
}

TEST_F(SurfaceTest, AxesEverywhereAndOfEverything) {
  for (const char* elevation : {"90", "-90", "0", "89.999", "-30"}) {
    for (const char* azimuth : {"0", "90", "-90", "45"}) {
      EXPECT_EQ(count_of(svg({"x*y", "--axes=grid", "--elevation", elevation, "--azimuth", azimuth}), "id=\"axes\""), 1u);
    }
  }
  EXPECT_EQ(count_of(svg("3 --axes"), "id=\"axes\""), 1u) << "a flat surface";
  EXPECT_EQ(count_of(svg("x*y --axes=box --eye 4,4,2 --target=-5,-5,0 --fov 90"), "id=\"axes\""), 1u)
      << "from within the box";
  EXPECT_EQ(count_of(svg("1e9+x --axes -x 0:1e-7 -y 0:1e9 --page a6"), "id=\"axes\""), 1u);
  fails("sqrt(-1-r) --axes -o a.svg", 1, "surface: sqrt(-1-r) has no value");
}

TEST_F(SurfaceTest, MistakesOfAxes) {
  fails("x --axes=cage -o a.svg", 2, "--axes: ");
  fails("x --x-label east -o a.svg", 2, "--x-label: needs --axes");
  fails("x --text ink -o a.svg", 2, "--text: ");
  fails("x --axes --text-height 0 -o a.svg", 2, "--text-height: ");
  fails("x --axes --text-height 100 -o a.svg", 2, "--text-height: 100 mm is more than a tenth of the 190 mm");
  fails({"x", "--axes", "--x-label", std::string(1000, 'n'), "-o", "a.svg"}, 2,
        "--page: numbers and names of the axes leave no drawable area");
  fails({"x", "--title", "\u6f22", "--text", "stroke", "-o", "a.svg"}, 0,
        "surface: warning: 1 characters are not in the font");
}

TEST_F(SurfaceTest, Mistakes) {
  fails("-o a.svg", 2, "surface: give a formula in x and y, or --grid FILE");
  fails("x+ -o a.svg", 1, "formula:");
  fails("x -x 3:1 -o a.svg", 2, "-x: the range 3:1 does not ascend");
  fails("x -x 0:1:1 -o a.svg", 2, "-x: ");
  fails("x -x 0:1:1000000000 -o a.svg", 2, "-x: ");
  fails("x -x 0 -o a.svg", 2, "-x: \"0\" is not A:B or A:B:N");
  fails("x --every 2 -o a.svg", 2, "--every: ");
  fails("x --resolution 2 -o a.svg", 2, "--resolution: ");
  fails("x --azimuth 2 --view top -o a.svg", 2, "--azimuth, --elevation: ");
  fails("--grid nowhere.csv -o a.svg", 1, "nowhere.csv: ");
  fails("sqrt(-1-r) -o a.svg", 1, "surface: sqrt(-1-r) has no value in the drawn range");
}

}  // namespace
}  // namespace ligne::test
