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

constexpr const char* kThreeLinesSvg =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"60mm\" viewBox=\"0 0 100 60\" fill=\"none\" "
    "stroke=\"black\">\n"
    "<path d=\"M20 20H45\"/><path d=\"M70 20H45\"/><path d=\"M70 20V40\" stroke=\"red\"/>\n</svg>\n";

class PlotTest : public ProgramTest {
 protected:
  std::string written(const std::string& name, const Words& arguments) const {
    const Outcome outcome = run_well(arguments + Words{"-o", name});
    return outcome.status == 0 ? contents(file(name)) : "";
  }
};

TEST_F(PlotTest, AnSvgBecomesHpglOfTrueSize) {
  write("a.svg", kThreeLinesSvg);
  const std::string hpgl = written("a.plt", "plot a.svg");
  // One stroke over the corner of both colours, in steps of 0.025 mm from the lower left of the page.
  EXPECT_EQ(hpgl, "IN;\nSP1;\nPU800,1600;\nPD2800,1600,2800,800;\nPU0,0;\nSP0;\n");
}

TEST_F(PlotTest, LinesAreEnteredAtTheirNearerEnds) {
  write("a.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' "
        "stroke='black'>\n"
        "<path d='M20 20H45'/><path d='M90 20H60'/>\n</svg>\n");
  EXPECT_EQ(written("a.plt", "plot a.svg"),
            "IN;\nSP1;\nPU800,1600;\nPD1800,1600;\nPU2400,1600;\nPD3600,1600;\nPU0,0;\nSP0;\n");
}

TEST_F(PlotTest, LoopsBeginAtTheNearestCornerAndEndThere) {
  write("a.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' "
        "stroke='black'>\n"
        "<path d='M20 20h20v20h-20z'/>\n</svg>\n");
  EXPECT_EQ(written("a.plt", "plot a.svg"), "IN;\nSP1;\nPU800,800;\nPD800,1600,1600,1600,1600,800,800,800;\nPU0,0;\nSP0;\n");
}

TEST_F(PlotTest, PensByColourAndLayersForOtherPrograms) {
  write("a.svg", kThreeLinesSvg);
  const std::string svg = written("b.svg", "plot a.svg --pen #ff0000=2,red,0.7 --pen rest=1,black");
  EXPECT_EQ(count_of(svg, "inkscape:groupmode=\"layer\""), 2u);
  expect_parts(svg, {"inkscape:label=\"1\"", "inkscape:label=\"2 #ff0000\"", "stroke-width=\"0.7\""});
  const std::string gcode = written("b.nc", "plot a.svg --pen #ff0000=2 --pen rest=1");
  EXPECT_EQ(count_of(gcode, "M0 (pen 2"), 1u);
  EXPECT_EQ(count_of(gcode, "M0 "), 1u);
}

TEST_F(PlotTest, ColoursStay) {
  write("a.svg", kThreeLinesSvg);
  const std::string svg = written("b.svg", "plot a.svg");
  expect_parts(svg, {"inkscape:label=\"#ff0000\" id=\"pen-#ff0000\" fill=\"none\" stroke=\"#f00\""});
  EXPECT_EQ(count_of(svg, "<path"), 2u) << "the two black lines are one";
}

constexpr const char* kLayered =
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' width='100mm' "
    "height='60mm' viewBox='0 0 100 60' fill='none' stroke='black' stroke-width='0.5'>\n"
    "<g inkscape:groupmode='layer' inkscape:label='3 red'><path d='M20 20H45' stroke='red'/><path d='M20 25H45' "
    "stroke='#800000' "
    "stroke-width='0.8'/></g>\n"
    "<g inkscape:groupmode='layer' inkscape:label='1 black'><path d='M20 30H45'/></g>\n"
    "<g inkscape:groupmode='layer' inkscape:label='%2 draft'><path d='M20 40H45'/></g>\n</svg>\n";

TEST_F(PlotTest, LayersKeepNamesColoursAndWidthsHoweverOften) {
  write("a.svg", kLayered);
  const std::string first = written("b.svg", "plot a.svg --device axidraw-v3"),
                    second = written("c.svg", "plot b.svg --device axidraw-v3");
  for (const char* label : {"\"3 red\"", "\"1 black\"", "\"%2 draft\""})
    EXPECT_EQ(count_of(first, std::string("inkscape:label=") + label), 1u) << first;
  EXPECT_EQ(count_of(first, "<g stroke=\"#f00\" stroke-width=\"0.5\""), 1u) << first;
  EXPECT_EQ(count_of(first, "stroke=\"#800000\" stroke-width=\"0.8\""), 1u) << first;
  EXPECT_EQ(second, first) << "a second pass changes nothing";
  const std::string plain = written("d.svg", "plot a.svg");
  EXPECT_EQ(count_of(plain, "inkscape:label=\"%2 draft\""), 1u);
  EXPECT_EQ(count_of(plain, "stroke-width=\"0.8\""), 1u) << plain;
  EXPECT_EQ(count_of(written("e.svg", "plot a.svg --pen-width 0.3"), "stroke-width=\"0.8\""), 0u);
  const std::string hpgl = written("a.hpgl", "plot a.svg");
  expect_parts(hpgl, {"SP1;", "SP3;"});
  EXPECT_EQ(hpgl.find("SP2;"), std::string::npos) << "a layer that is not plotted";
}

TEST_F(PlotTest, FillsAreOutlinedWithOneWarning) {
  write("a.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60'>\n"
        "<rect x='10' y='10' width='9' height='9'/><rect x='30' y='10' width='9' height='9' fill='url(#g)'/><plotdata/>"
        "<pattern id='g'/></svg>");
  const Outcome plain = run_well("plot a.svg -o a.hpgl");
  EXPECT_EQ(count_of(plain.err, "2 filled areas are drawn by the outline"), 1u) << plain.err;
  EXPECT_EQ(count_of(plain.err, "left out: 1 <plotdata> elements"), 1u) << plain.err;
  EXPECT_EQ(count_of(run("plot a.svg --fill outline -o a.hpgl").err, "filled"), 0u);
  expect_outcome("plot a.svg --fill refuse -o b.hpgl", 1, {"--fill outline or --fill hatch draws it"});
}

TEST_F(PlotTest, OrderingCutsAndJoinsNothing) {
  write("a.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' "
        "stroke='black'>\n"
        "<path d='M20 20H90'/><path d='M20 50H30'/><path d='M20 20H90'/></svg>");
  EXPECT_EQ(count_of(written("a.hpgl", "plot a.svg --optimize order"), "PD"), 3u);
  EXPECT_EQ(count_of(written("b.hpgl", "plot a.svg"), "PD"), 2u);
}

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

TEST_F(PlotTest, ReportAndPreview) {
  write("a.svg", kThreeLinesSvg);
  expect_outcome("plot a.svg --report --preview way.svg -o a.gcode", 0,
                 {"before             3     0.070 m", "after              1     0.070 m"});
  EXPECT_NE(contents(file("way.svg")).find("id=\"pen-up\""), std::string::npos);
  EXPECT_NE(contents(file("way.svg")).find("id=\"order-1\""), std::string::npos);
}

TEST_F(PlotTest, ScaleAndPage) {
  write("a.svg", kThreeLinesSvg);
  EXPECT_NE(written("a.plt", "plot a.svg --scale 2:1").find("PU1600,3200;\nPD5600,3200,5600,1600;"), std::string::npos);
  // 50 mm wide, made to fill 100 mm between the margins.
  const std::string fit = written("b.plt", "plot a.svg --scale fit --page 120x120 --margin 10");
  expect_parts(fit, {"PU400,", "4400,"});
}

TEST_F(PlotTest, StrictReadingRefusesByNameAndLeavesNothingBehind) {
  write("bad.svg", "<svg width='10mm' height='10mm' viewBox='0 0 10 10'>\n<image/></svg>");
  expect_error("plot bad.svg --strict -o bad.hpgl", 1,
               "ligne: bad.svg:2: <image> has image, which can not be drawn as strokes; --skip image leaves it out\n");
  EXPECT_FALSE(exists("bad.hpgl"));
  expect_outcome("plot bad.svg --strict --skip image,text -o bad.hpgl", 0, {"1 times image left out"});
}

TEST_F(PlotTest, WhatCanNotBeDrawnIsOneWarning) {
  write("part.svg",
        "<svg width='10mm' height='10mm' viewBox='0 0 10 10'>\n<image/><image/><path d='M1 1H9LNaN' stroke='red'/></svg>");
  const Outcome part = run_well("plot part.svg -o part.hpgl");
  EXPECT_EQ(part.err,
            "ligne: part.svg: warning: left out: 2 images, 1 ends of <path> elements after an error; the first in line 2\n");
  EXPECT_TRUE(exists("part.hpgl"));
}

TEST_F(PlotTest, ADrawingOfWhichNothingIsLeftFails) {
  write("none.svg", "<svg width='10mm' height='10mm' viewBox='0 0 10 10'>\n<image/></svg>");
  expect_error("plot none.svg -o none.hpgl", 1,
               "ligne: none.svg: nothing is left to draw; left out: 1 images; the first in line 2\n");
  EXPECT_FALSE(exists("none.hpgl"));
  write("empty.svg", "<svg width='10mm' height='10mm' viewBox='0 0 10 10'/>");
  expect_outcome("plot empty.svg -o empty.svg.hpgl", 0, {"there is no stroke in the drawing"});
}

TEST_F(PlotTest, PensAndWidthsOfLayersThatAreNotThere) {
  write("a.svg", kThreeLinesSvg);
  const std::string layers = "there are #000000, #ff0000\n";
  for (const std::string option : {"--pen", "--width"}) {
    const Outcome named = run({"plot", "a.svg", option, "#ff0000=2", "-o", "a.out.svg"});
    EXPECT_EQ(named.status, 0);
    EXPECT_EQ(named.err, "");
    const Outcome absent = run({"plot", "a.svg", option, "crease=3", option, "#ff0000=2", "-o", "b.svg"});
    EXPECT_EQ(absent.status, 0);
    EXPECT_EQ(absent.err, "ligne: a.svg: warning: has no layer crease for " + option + "; " + layers);
    EXPECT_EQ(contents(file("b.svg")), contents(file("a.out.svg")));
    EXPECT_EQ(run({"plot", "a.svg", option, "crease=2", "--quiet", "-o", "b.svg"}).err, "");
  }
  // A file of pens may name every layer there is.
  write("pens.toml", "[[pen]]\nnumber = 2\nclasses = [\"crease\"]\n[[pen]]\nnumber = 1\nrest = true\n");
  EXPECT_EQ(run({"plot", "a.svg", "--pens", "pens.toml", "-o", "c.svg"}).err, "");
}

TEST_F(PlotTest, APenOfALayerThatIsOnOneSheetAlone) {
  write("long.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='60mm' viewBox='0 0 200 60' fill='none'>\n"
        "<path d='M10 20H45' stroke='black'/><path d='M150 20H190' stroke='red'/>\n</svg>\n");
  const Outcome outcome =
      run({"plot", "long.svg", "--tile", "120x80", "--pen", "#ff0000=2", "--pen", "rest=1", "-o", "sheet%d.hpgl"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(contents(file("sheet2.hpgl")).find("SP2;"), std::string::npos);
}

TEST_F(PlotTest, ResolutionOfTheInput) {
  write("old.svg", "<svg viewBox='0 0 595 842'>\n<path d='M0 72H72' stroke='red'/></svg>");
  expect_outcome(
      "plot old.svg -o a.svg", 0,
      {"old.svg: warning: has no size; its viewBox is a paper size (A4) at 72 dpi, and is read at 96: --input-dpi 72 gives "
       "that paper"});
  const Outcome right = run("plot old.svg --input-dpi 72 -o b.svg");
  EXPECT_EQ(right.err, "");
  EXPECT_NE(contents(file("b.svg")).find("M0 25.4l25.4 0"), std::string::npos) << contents(file("b.svg"));
  expect_outcome("plot old.svg --input-dpi none -o c.svg", kUsage, {"--input-dpi"});
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

TEST_F(PlotTest, PackedAndWideTextsAreToldHowToGoIn) {
  write("packed.svgz", "\x1f\x8b\x08 and so on");
  write("wide.svg", std::string("\xff\xfe<\0s\0v\0g\0", 10));
  EXPECT_EQ(run("plot packed.svgz -o a.svg").err,
            "ligne: packed.svgz: is compressed; gzip -dc FILE | ligne plot - reads it\n");
  EXPECT_EQ(run("plot wide.svg -o a.svg").err, "ligne: wide.svg: is UTF-16 text; save it as UTF-8\n");
}

TEST_F(PlotTest, TheSameBytesWithAnyNumberOfThreads) {
  const Words surface = "surface sin(r)/r -x -12:12:30 -y -12:12:30 --margin 20 --device hp7475a";
  const std::string text = written("one.hpgl", surface + "--threads 1");
  EXPECT_GT(text.size(), 10'000u);
  EXPECT_EQ(text, written("four.hpgl", surface + "--threads 4"));
}

TEST_F(PlotTest, ADeviceOfOnesOwn) {
  write("mine.toml",
        "name = \"mine\"\ntitle = \"My plotter\"\nlanguage = \"hpgl\"\nstep = 0.1\nlimits = [0, 0, 200, 300]\nbegin = "
        "[\"HELLO\"]\n"
        "travel = \"U{x},{y};\"\ndraw = \"D{points};\"\ndot = \"D;\"\nspeed_down = 10\nspeed_up = 20\nlift_seconds = "
        "1\npen_change_seconds = 1\n");
  write("a.svg", kThreeLinesSvg);
  EXPECT_EQ(written("a.hpgl", "plot a.svg --device-file mine.toml"), "HELLO\nU200,400;\nD700,400,700,200;\n");
}

TEST_F(PlotTest, DevicesAreListedWhereverTheProgramIs) {
  const Outcome text = run_well("devices");
  expect_parts(text.out, {"hp7475a: HP 7475A"});
  const Outcome list = run("devices --json");
  const json parsed = json::parse(list.out);
  EXPECT_EQ(parsed["format"], "ligne-devices");
  EXPECT_GE(parsed["devices"].size(), 8u);
}

TEST_F(PlotTest, WhatLeavesTheLimitsIsToldInMillimetres) {
  write("wide.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='210mm' height='297mm' viewBox='0 0 210 297' fill='none' "
        "stroke='black'>"
        "<path d='M0 0H210V297'/></svg>");
  const Outcome outcome = run("plot wide.svg --device hp7475a -o a.hpgl");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.err.starts_with("ligne: device hp7475a, paper A4: the drawing leaves the limits: ")) << outcome.err;
  const Outcome fitted = run_well("plot wide.svg --device hp7475a --fit-device --report -o a.hpgl");
  EXPECT_EQ(count_of(fitted.err, "the drawing is scaled down to 0.9"), 1u) << fitted.err;
  EXPECT_EQ(count_of(fitted.err, "of its size, which fits hp7475a\n"), 1u) << "in the title of the report";
}

TEST_F(PlotTest, ADrawingWithoutAScaleFitsTheDevice) {
  for (const char* device : {"hp7475a", "hp7550a", "designjet", "cutter"}) {
    const Outcome outcome = run_well({"draw", "cube.obj", "--margin", "0", "--device", device, "-o", "a.hpgl"});
    EXPECT_EQ(outcome.err, "") << "no scale was asked for";
  }
  run_well("surface x*y --margin 0 --device hp7475a -o a.hpgl");
}

TEST_F(PlotTest, PensForWhatIsNotThereAreMistakes) {
  write("a.svg", kThreeLinesSvg);
  expect_outcome("plot a.svg --pen nonsense=2 -o a.hpgl", 2,
                 {"there is no layer \"nonsense\"; there are #000000, #ff0000;"});
  EXPECT_EQ(run("draw cube.obj --pen surface:2=2 -o a.svg").status, 2);
  EXPECT_EQ(run("draw cube.obj --pen mesh=2 -o a.svg").status, 0) << "a class that has no line this time";
  write("two.json",
        R"({"format":"ligne-scene","version":1,"materials":[{"name":"steel"},{"name":"glass","color":[0,0.5,1]}],"objects":[
{"vertices":[[0,0,0],[10,0,0],[10,10,0],[0,10,0]],"faces":[{"outer":[0,1,2,3],"material":0}]}]})");
  const Outcome material = run("draw two.json --view top --pen material:brass=2 -o a.svg");
  EXPECT_EQ(material.status, 2);
  expect_parts(material.err, {"no material is called \"brass\"; there are steel, glass"});
  EXPECT_EQ(run("draw two.json --view top --pen material:glass=2 -o a.svg").status, 0) << "not seen";
  const json info = json::parse(run("info two.json --json").out);
  EXPECT_EQ(info["scene"]["materials"][1]["name"], "glass");
  EXPECT_EQ(info["scene"]["materials"][1]["color"], "#0080ff");
  EXPECT_EQ(info["scene"]["materials"][0]["faces"], 1);
  EXPECT_EQ(info["scene"]["objects"][0]["materials"], json::array({"steel"}));
  EXPECT_NE(run("info two.json").out.find("glass #0080ff"), std::string::npos);
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

TEST_F(PlotTest, ShortStrokesAreLeftOut) {
  write("a.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60' fill='none' "
        "stroke='black'>\n"
        "<path d='M20 20H20.4'/><path d='M20.4 20H22'/><path d='M50 50H50.5'/></svg>");
  EXPECT_EQ(count_of(written("a.hpgl", "plot a.svg --min-length 1"), "PD"), 1u) << "pieces of one line are one";
  EXPECT_EQ(count_of(written("a.hpgl", "plot a.svg"), "PD"), 2u);
}

TEST_F(PlotTest, MaterialsHavePens) {
  write("two.json", R"({"format":"ligne-scene","version":1,"materials":[{"name":"steel"},{"name":"glass"}],"objects":[
{"vertices":[[0,0,0],[10,0,0],[10,10,0],[0,10,0]],"faces":[{"outer":[0,1,2,3],"material":0}]},
{"vertices":[[20,0,0],[30,0,0],[30,10,0],[20,10,0]],"faces":[{"outer":[0,1,2,3],"material":1}]}]})");
  const Outcome outcome = run_well("draw two.json --view top --pen material:glass=2,blue --pen rest=1 -o two.svg");
  const std::string svg = contents(file("two.svg"));
  EXPECT_EQ(count_of(svg, "inkscape:groupmode=\"layer\""), 2u);
  EXPECT_EQ(count_of(svg, "<path"), 2u);
}

/// The report counts the ways that the file has, and with `rest` two numbered layers are one pen.
TEST_F(PlotTest, RestIsOnePenForNumberedLayers) {
  write("two.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
        "width='100mm' height='100mm' viewBox='0 0 100 100' stroke='black'>"
        "<g inkscape:groupmode='layer' inkscape:label='1-Black'><path d='M10 10H90'/></g>"
        "<g inkscape:groupmode='layer' inkscape:label='2-Red'><path d='M10 20H90'/></g></svg>");
  const Outcome both = run("plot two.svg --device grbl-servo --report -o x.gcode");
  EXPECT_EQ(count_of(contents(file("x.gcode")), "M0 "), 1u);
  EXPECT_EQ(count_of(both.err, "0.292 m"), 2u) << both.err;
  run_well("plot two.svg --device grbl-servo --pen rest=1 -o x.gcode");
  EXPECT_EQ(count_of(contents(file("x.gcode")), "M0 "), 0u);
}

}  // namespace
}  // namespace ligne::test
