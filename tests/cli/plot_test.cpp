/// ligne plot, ligne devices, and the plotter's options of the other commands, as a user runs them.

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "plotting/paths/optimize.hpp"
#include "plotting/readers/drawing_reader.hpp"
#include "program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class PlotTest : public ProgramTest {
 protected:
  std::string written(const std::string& name, const Words& arguments) const {
    const Outcome outcome = run_well(arguments + Words{"-o", name});
    return outcome.status == 0 ? contents(file(name)) : "";
  }
};

TEST_F(PlotTest, DrawingsOfOursComeAsJsonAndAsSvg) {
  run_well("draw cube.obj --margin 20 -o cube.json");
  ASSERT_EQ(run("draw cube.obj --margin 20 -o cube.svg").status, 0);
  const std::string direct = written("direct.hpgl", "draw cube.obj --margin 20 --device hp7475a");
  const std::string json_way = written("json.hpgl", "plot cube.json --device hp7475a");
  const std::string svg_way = written("svg.hpgl", "plot cube.svg --device hp7475a");
  EXPECT_EQ(count_of(direct, "PU"), count_of(json_way, "PU"));
  EXPECT_EQ(count_of(direct, "PU"), count_of(svg_way, "PU"));
  EXPECT_EQ(json_way.size(), direct.size());
}

TEST_F(PlotTest, CurvesWhereThePenArrives) {
  write("round.svg",
        "<svg width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' stroke='black'><circle cx='70' cy='40' r='8'/>"
        "<path d='M20 10l8.66 5v10l-8.66 5l-8.66-5v-10z'/><circle cx='30' cy='40' r='5'/></svg>");
  const auto begins = [&](const std::string& svg) {
    std::vector<std::string> starts;
    for (std::size_t at = svg.find("d=\"M"); at != std::string::npos; at = svg.find("d=\"M", at + 1))
      starts.push_back(svg.substr(at + 4, svg.find_first_of("cClLZ", at + 4) - at - 4));
    return starts;
  };
  const auto curved_paths = [](const std::string& svg) {
    int count = 0;
    for (std::size_t at = svg.find("d=\"M"); at != std::string::npos; at = svg.find("d=\"M", at + 1))
      count += svg.substr(at + 3, svg.find('"', at + 3) - at - 3).find_first_of("cC") != std::string::npos;
    return count;
  };
  for (const std::string optimize : {"join", "full"}) {
    const Words command{"plot", "round.svg", "--pen", "rest=1,black,0.3", "--optimize", optimize};
    Words curved = command + "--curves on";
    const std::string lines = written("l.svg", command), curves = written("c.svg", curved);
    EXPECT_EQ(begins(lines).size(), 3u);
    EXPECT_EQ(begins(curves), begins(lines)) << curves;
    EXPECT_LT(curves.size() * 2, lines.size());
    EXPECT_EQ(curved_paths(curves), 2) << "not the hexagon: " << curves;
    EXPECT_EQ(curved_paths(lines), 0);
  }
  EXPECT_LT(written("plain.svg", "plot round.svg --curves on").size() * 2, written("plain-l.svg", "plot round.svg").size());
}

/// Millimetres of hatching in the layer.
double hatch_length(const std::string& svg) {
  const ReadDrawing read = read_svg_drawing(svg, "a.svg", {});
  double length = 0;
  for (const Layer& layer : read.drawing.layers) {
    if (layer.name == "hatch") length += measure(layer.lines, {0, 0}, false).down_mm;
  }
  return length;
}

TEST_F(PlotTest, AStoredStudyIsHatched) {
  run_well("draw cube.obj --method atherton-weiler --direction 1,2,-1.5 --scale 20:1 -o cube.json");
  const double plain = hatch_length(written("a.svg", "plot cube.json --fill hatch")),
               shaded = hatch_length(written("b.svg", "plot cube.json --hatch shade")),
               wide = hatch_length(written("c.svg", "plot cube.json --hatch plain --hatch-spacing 2")),
               large = hatch_length(written("d.svg", "plot cube.json --fill hatch --scale 2:1"));
  EXPECT_GT(shaded, 0);
  EXPECT_GT(plain, 2 * shaded);
  EXPECT_NEAR(wide, plain * 0.8 * 0.18 / 2, 0.15 * wide);
  EXPECT_NEAR(large, 4 * plain, 0.1 * large) << "as close as the pen is wide, whatever the scale";
  const std::string drawn =
      written("e.svg", "draw cube.obj --direction 1,2,-1.5 --scale 20:1 --hatch shade --hatch-levels continuous");
  EXPECT_NEAR(shaded, hatch_length(drawn), 0.1 * shaded) << "as draw does it";
  run_well("draw cube.obj -o lines.json");
  const Outcome none = run("plot lines.json --fill hatch -o f.svg");
  EXPECT_TRUE(none.status == 0 || none.err.find("has no regions to hatch") != std::string::npos) << none.err;
}

TEST_F(PlotTest, FillsAreHatchedByLayerColourAndTone) {
  write("a.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60'>\n"
        "<rect x='10' y='10' width='20' height='20' fill='red'/><rect x='40' y='10' width='20' height='20' fill='#00f'/>"
        "<rect x='70' y='10' width='20' height='20' fill='#ddd'/></svg>");
  const auto lengths = [&](const Words& options) {
    const ReadDrawing read = read_svg_drawing(written("b.svg", "plot a.svg" + options), "b.svg", {});
    std::map<std::string, double> by_layer;
    for (const Layer& layer : read.drawing.layers) by_layer[layer.name] += measure(layer.lines, {0, 0}, false).down_mm - 80;
    return by_layer;
  };
  std::map<std::string, double> found = lengths("--hatch-spacing 2 --hatch-spacing red=1 --hatch-angle red=0");
  EXPECT_NEAR(found["#ff0000"], 400, 30);
  EXPECT_NEAR(found["#0000ff"], 200, 30);
  found = lengths("--hatch shade");
  EXPECT_NEAR(found["#dddddd"], 400 * 0.133 / 0.35, 40) << "an eighth of the paper is covered";
  EXPECT_GT(found["#0000ff"], 5 * found["#dddddd"]);
}

TEST_F(PlotTest, CrossHatchingTakesNoFileForAName) {
  write("a.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60'>\n"
        "<rect x='10' y='10' width='20' height='20' fill='red'/><rect x='40' y='10' width='20' height='20' fill='#00f'/>"
        "</svg>");
  const auto length = [&](const Words& options) {
    const ReadDrawing read = read_svg_drawing(written("b.svg", "plot --hatch-spacing 2" + options), "b.svg", {});
    double length = 0;
    for (const Layer& layer : read.drawing.layers) length += measure(layer.lines, {0, 0}, false).down_mm;
    return length;
  };
  const double plain = length("a.svg"), red = length("--hatch-cross=red a.svg");
  EXPECT_GT(red, plain + 100);
  EXPECT_NEAR(length("--hatch-cross a.svg"), length("a.svg --hatch-cross"), 1e-9);
  EXPECT_GT(length("--hatch-cross a.svg"), red + 100) << "all fills";
  EXPECT_NEAR(length("--hatch-cross=red --hatch-cross=blue a.svg"), length("--hatch-cross a.svg"), 1e-9);
}

TEST_F(PlotTest, WhatIsResumedIsTheEndOfTheWhole) {
  write(
      "a.svg",
      "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' stroke='black'>\n"
      "<path d='M10 10H50'/><path d='M10 20H50'/><path d='M10 30H50' stroke='red'/><path d='M10 40H50' stroke='red'/></svg>");
  const auto made = [&](const Words& arguments) { run_well("plot" + arguments); };
  made("a.svg -o whole.gcode");
  made("a.svg --from-stroke 3 -o rest.gcode");
  const std::string whole = contents(file("whole.gcode")), rest = contents(file("rest.gcode"));
  EXPECT_EQ(count_of(rest, "M3 S90"), 2u);
  const std::string strokes = rest.substr(rest.find("G0 X"));
  EXPECT_TRUE(whole.ends_with(strokes));
  // The first stroke takes 22 mm of way, a lift and 40 mm of line: 1.5 s; the second is drawn at that time.
  made("a.svg --from-time 2s -o rest.gcode");
  EXPECT_EQ(count_of(contents(file("rest.gcode")), "M3 S90"), 3u);
  expect_error("plot a.svg --from-time soon -o a.gcode", kUsage,
               "ligne: --from-time: \"soon\" is not a time such as 90s, 30min, 2h or 12:30\n");
}

}  // namespace
}  // namespace ligne::test
