/// HPGL and G-code, command by command: goldens of every device, replayed by machines that complain.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <glm/geometric.hpp>

#include "gcode_interpreter.hpp"
#include "golden_file.hpp"
#include "plotting/dashes.hpp"
#include "plotting/plot_writers.hpp"
#include "sample_drawing.hpp"

namespace ligne {
namespace {

using test::PenKind;
using test::Replay;

/// A frame, a diagonal, a dot, and a dashed line, on A4 with room for every device.
Drawing plotter_drawing() {
  Drawing drawing;
  add_line(drawing, "hidden", {{30, 60}, {70, 60}});
  add_line(drawing, "mesh", {{40, 100}, {60, 120}, {80, 100}});
  add_line(drawing, "mesh", {{100, 100}, {100, 100}});
  add_line(drawing, "outline", {{30, 40}, {180, 40}, {180, 240}, {30, 240}, {30, 40}});
  add_line(drawing, "outline", {{30, 40}, {180, 240}});
  return drawing;
}

PlotRequest request_for(const Drawing&, bool two_pens) {
  PlotRequest request;
  if (two_pens) {
    add_pen(request.pens, "outline=1,black,0.5");
    add_pen(request.pens, "rest=2,#0000ff,0.3");
    request.pens.pens[2].name = "blue (fine)";
    request.pens.pens[2].speed = 50;
  }
  return request;
}

struct Written {
  Plot plot;
  DeviceFrame frame;
  std::string text;
};

Written written(const Device& device, const Drawing& drawing, bool two_pens, bool fit = false) {
  PlotRequest request = request_for(drawing, two_pens);
  Written w;
  w.frame = place_on_device(device, request.style.page, ink_of(drawing), fit);
  request.paths.order.home = w.frame.to_page({0, 0});
  request.paths.order.returns = device.returns;
  w.plot = make_plot(drawing, request);
  w.text = write_plot(w.plot, device, w.frame);
  return w;
}

PenKind kind_of(const Device& device) {
  return device.name == "grbl-z"                ? PenKind::z
         : device.name == "grbl-servo-reversed" ? PenKind::servo_reversed
                                                : PenKind::servo;
}

Replay replay(const Device& device, const std::string& text) {
  return device.language == DeviceLanguage::hpgl ? test::replay_hpgl(text) : test::replay_gcode(text, kind_of(device));
}

std::vector<std::string> plotters() {
  std::vector<std::string> names;
  for (const Device& device : devices()) {
    if (device.language != DeviceLanguage::svg) names.push_back(device.name);
  }
  return names;
}

class EveryPlotter : public testing::TestWithParam<std::string> {
 protected:
  const Device& device() const { return *find_device(GetParam()); }
};

TEST_P(EveryPlotter, WritesItsGolden) {
  const std::string suffix = device().language == DeviceLanguage::hpgl ? ".hpgl" : ".gcode";
  expect_golden("plot-" + GetParam() + suffix, written(device(), plotter_drawing(), true).text);
}

TEST_P(EveryPlotter, DrawsWhatThePlotHolds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(20, 190), y(30, 260);
  Drawing drawing = plotter_drawing();
  for (int i = 0; i < 200; ++i) {
    std::vector<Point2> line;
    for (int k = 0; k < 2 + i % 7; ++k) line.push_back({x(random), y(random)});
    add_line(drawing, i % 2 ? "crease" : "border", line);
  }
  for (const bool two_pens : {false, true}) {
    const Written w = written(device(), drawing, two_pens);
    const Replay got = replay(device(), w.text);
    EXPECT_EQ(got.faults, std::vector<std::string>{});
    EXPECT_TRUE(got.ends_up);
    const double unit = device().language == DeviceLanguage::hpgl ? device().step_mm : 1;
    std::size_t stroke = 0;
    for (const PenLines& pen : w.plot.pens) {
      for (std::size_t i = 0; i < pen.lines.size(); ++i, ++stroke) {
        ASSERT_LT(stroke, got.strokes.size());
        const auto line = pen.lines[i];
        const auto& drawn = got.strokes[stroke];
        // Each drawn point is the image of the next point, within half a step in x and in y.
        std::size_t k = 0;
        for (const Point2 p : line) {
          const Point2 wanted = w.frame.to_device(p);
          if (k + 1 < drawn.size() && glm::distance(wanted, drawn[k] * unit) > device().step_mm * 0.7072) ++k;
          ASSERT_LE(glm::distance(wanted, drawn[k] * unit), device().step_mm * 0.7072);
        }
        EXPECT_EQ(k + 1, drawn.size());
      }
    }
    EXPECT_EQ(stroke, got.strokes.size());
    const double step = device().language == DeviceLanguage::hpgl ? 1 : device().step_mm;
    EXPECT_GE(got.reach.min.x, w.frame.limits.min.x * step - 1e-9);
    EXPECT_GE(got.reach.min.y, w.frame.limits.min.y * step - 1e-9);
    EXPECT_LE(got.reach.max.x, w.frame.limits.max.x * step + 1e-9);
    EXPECT_LE(got.reach.max.y, w.frame.limits.max.y * step + 1e-9);
  }
}

TEST_P(EveryPlotter, RefusesWhatLeavesTheLimitsOrMakesItFit) {
  Drawing drawing;
  add_line(drawing, "outline", {{-40, -50}, {500, 700}});
  const Page page;
  try {
    place_on_device(device(), page, ink_of(drawing), false);
    FAIL() << "a drawing that leaves the sheet was accepted";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find(" mm "), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("--fit-device"), std::string::npos) << e.what();
  }
  const Written w = written(device(), drawing, false, true);
  const Replay got = replay(device(), w.text);
  const double step = device().language == DeviceLanguage::hpgl ? 1 : device().step_mm;
  EXPECT_GE(got.reach.min.x, w.frame.limits.min.x * step - 1e-9);
  EXPECT_LE(got.reach.max.y, w.frame.limits.max.y * step + 1e-9);
  const Point2 across = w.frame.to_device({1, 0}) - w.frame.to_device({0, 0}),
               down = w.frame.to_device({0, 1}) - w.frame.to_device({0, 0});
  EXPECT_NEAR(glm::length(across), glm::length(down), 1e-12) << "made smaller alike in both directions";
  EXPECT_NEAR(glm::distance(w.frame.to_page(w.frame.to_device({12, 34})), Point2(12, 34)), 0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Devices, EveryPlotter, testing::ValuesIn(plotters()), [](const auto& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
});

TEST(Devices, ThatTakeSvgWriteTheirGoldens) {
  std::size_t count = 0;
  for (const Device& device : devices()) {
    if (device.language != DeviceLanguage::svg) continue;
    Written w = written(device, plotter_drawing(), true, true);
    for (PenLines& pen : w.plot.pens) {
      for (Point2& p : pen.lines.points) p = w.frame.fitted(p);
    }
    PlotOptions options;
    options.style = styles_of(w.plot);
    expect_golden("plot-" + device.name + ".svg", write_svg(drawing_of(w.plot), options));
    ++count;
  }
  EXPECT_EQ(count, 7u);
}

TEST(Devices, AreTheOnesThatAreOwed) {
  for (const char* name :
       {"hp7475a", "hp7550a", "designjet", "cutter", "axidraw-v3", "grbl-servo", "grbl-servo-reversed", "grbl-z"}) {
    EXPECT_NE(find_device(name), nullptr) << name;
  }
  EXPECT_EQ(find_device("hp7475a")->step_mm, 0.02488);
  EXPECT_EQ(find_device("nothing"), nullptr);
}

TEST(Devices, AMillimetreIsAMillimetreOnThe7475A) {
  const Device& device = *find_device("hp7475a");
  Drawing drawing;
  add_line(drawing, "outline", {{50, 50}, {150, 50}});
  const Replay got = test::replay_hpgl(written(device, drawing, false).text);
  ASSERT_EQ(got.strokes.size(), 1u);
  EXPECT_NEAR(glm::distance(got.strokes[0][0], got.strokes[0][1]) * 0.02488, 100, 0.025);
  // An A4 page that stands lies on its left side: across the page is along -y of the device, its middle is the sheet's.
  const DeviceFrame frame = place_on_device(device, {}, {}, false);
  EXPECT_NEAR(glm::distance(frame.to_device({105, 148.5}), Point2(148.5 - 9.1, 105 - 2.47)), 0, 1e-9);
}

/// The manual of the 7475A: its default points P1 and P2 lie about the middle of every paper.
TEST(Devices, TheMiddleOfP1AndP2IsThatOfThePaperOnThe7475A) {
  struct Points {
    const char* paper;
    Point2 p1, p2;
  };
  const Device& device = *find_device("hp7475a");
  for (const Points& points : {Points{"A4", {603, 521}, {10603, 7721}}, Points{"A3", {170, 602}, {15370, 10602}},
                               Points{"letter", {250, 596}, {10250, 7796}}, Points{"tabloid", {522, 259}, {15722, 10259}}}) {
    const auto paper = std::find_if(device.papers.begin(), device.papers.end(),
                                    [&](const DevicePaper& p) { return p.name == points.paper; });
    ASSERT_NE(paper, device.papers.end()) << points.paper;
    const Point2 middle = *paper->origin_mm + (points.p1 + points.p2) * (0.5 * device.step_mm);
    EXPECT_NEAR(glm::distance(middle, Point2(paper->width_mm, paper->height_mm) * 0.5), 0, 0.01) << points.paper;
    for (const Point2 p : {points.p1, points.p2}) {
      EXPECT_TRUE(p.x <= paper->limits.max.x && p.y <= paper->limits.max.y) << points.paper;
    }
    const Point2 far = *paper->origin_mm + paper->limits.max * device.step_mm;
    EXPECT_TRUE(far.x < paper->width_mm && far.y < paper->height_mm) << points.paper;
  }
}

TEST(Devices, ErrorsNameFileAndLine) {
  const auto error_of = [](const std::string& toml) -> std::string {
    try {
      read_device(toml, "my.toml");
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_TRUE(error_of("name = ").starts_with("my.toml:1: "));
  EXPECT_EQ(error_of("name = \"a\"\ntitle = \"b\"\nlanguage = \"dxf\"\n"), "my.toml:3: language is not hpgl, gcode or svg");
  EXPECT_EQ(error_of("name = \"a\"\ncolour = 3\n"), "my.toml:2: there is no key colour");
  EXPECT_EQ(error_of("name = \"a\"\ntitle = \"b\"\nlanguage = \"svg\"\nstep = -1\n"),
            "my.toml:4: step is not from 0.0001 to 10 mm");
  EXPECT_TRUE(error_of("").starts_with("my.toml"));
}

TEST(Pens, ThatTheDeviceDoesNotHoldAreRefused) {
  PlotRequest request;
  add_pen(request.pens, "rest=7");
  const Drawing drawing = plotter_drawing();
  const Device& device = *find_device("hp7475a");
  const DeviceFrame frame = place_on_device(device, {}, ink_of(drawing), false);
  EXPECT_THROW(write_plot(make_plot(drawing, request), device, frame), std::runtime_error);
}

TEST(Pens, LabelsAreWhatOtherProgramsRead) {
  Pen pen;
  pen.number = 3;
  EXPECT_EQ(layer_label(pen), "3");
  pen.name = "red 0.5";
  pen.pause = pen.skip = true;
  pen.speed = 30;
  pen.height = 50;
  pen.delay_ms = 250;
  EXPECT_EQ(layer_label(pen), "%!3+S30+H50+D250 red 0.5");
}

TEST(Pens, LabelsAreReadAsTheyAreWritten) {
  const LayerLabel label = parse_layer_label("%!3+S30+H50+D250 red 0.5");
  EXPECT_EQ(label.number, 3u);
  EXPECT_TRUE(label.skip && label.pause);
  EXPECT_EQ(label.speed, 30u);
  EXPECT_EQ(label.height, 50u);
  EXPECT_EQ(label.delay_ms, 250u);
  EXPECT_EQ(label.name, "red 0.5");
  EXPECT_EQ(parse_layer_label("12-layer").number, 12u);
  EXPECT_EQ(parse_layer_label("2001 a space odyssey").number, 0u) << "no plotter holds so many";
  EXPECT_EQ(parse_layer_label("2001 a space odyssey").name, "2001 a space odyssey");
  EXPECT_EQ(parse_layer_label("99999999999").number, 0u);
  EXPECT_EQ(parse_layer_label("1+s0+h101+d9999999+x3 y").name, "+x3 y");
  EXPECT_FALSE(parse_layer_label("1+s0+h101+d9999999+x3 y").speed);
  EXPECT_FALSE(parse_layer_label("1+s0+h101+d9999999+x3 y").delay_ms);
  EXPECT_EQ(parse_layer_label("red").name, "red");
  EXPECT_TRUE(parse_layer_label("").name.empty());
}

Drawing layers_of(const std::vector<std::string>& names) {
  Drawing drawing;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double y = 10.0 * static_cast<double>(i + 1);
    drawing.layers.push_back({names[i], {}});
    drawing.layers.back().lines.add(std::vector<Point2>{{20, y}, {40, y}});
  }
  return drawing;
}

std::vector<std::string> names_of(const Drawing& drawing) {
  std::vector<std::string> names;
  for (const Layer& layer : drawing.layers) names.push_back(layer.name);
  return names;
}

TEST(Pens, LayersKeepTheirNames) {
  PlotRequest request;
  request.pen_per_layer = request.keep_looks = true;
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of(drawing_of(make_plot(layers_of({"3 red", "1 black", "%2 draft", "% note", "1 black too"}), request))),
            (Names{"1 black", "% note", "1 black too", "%2 draft", "3 red"}));
  const Drawing once = drawing_of(make_plot(layers_of({"crease", "outline", "1 pencil"}), request));
  EXPECT_EQ(names_of(once), (Names{"1 pencil", "2 crease", "3 outline"})) << "those without a number get one that is free";
  EXPECT_EQ(names_of(drawing_of(make_plot(once, request))), names_of(once)) << "and keep it";
}

TEST(Pens, WhatLayersSayOfPensIsDone) {
  const Drawing drawing = layers_of({"2+D250+S50 slow", "%3 note", "!2 again", "1"});
  const Plot plot = make_plot(drawing, {});
  const Device& grbl = *find_device("grbl-servo");
  const std::string gcode = write_plot(plot, grbl, place_on_device(grbl, {}, ink_of(plot), false));
  EXPECT_EQ(gcode.find("pen 3"), std::string::npos) << "not plotted";
  EXPECT_NE(gcode.find("M0 (pen 2: slow)\nG4 P0.25\n"), std::string::npos) << gcode;
  EXPECT_NE(gcode.find("G1 F1200"), std::string::npos) << "half its speed";
  EXPECT_NE(gcode.find("M0 (pen 2: again)\n"), std::string::npos) << "a pause";
  const Device& hp = *find_device("cutter");
  const std::string hpgl = write_plot(plot, hp, place_on_device(hp, {}, ink_of(plot), false));
  EXPECT_EQ(hpgl.find("SP3"), std::string::npos);
  EXPECT_NE(hpgl.find("SP2;\nVS5;"), std::string::npos) << hpgl;
  EXPECT_EQ(hpgl.find("SP2", hpgl.find("SP2") + 1), std::string::npos) << "it is held already";
  EXPECT_NE(hpgl.find("VS10;"), std::string::npos) << "as fast as usual again";
  EXPECT_EQ(measure(plot, {0, 0}, false).strokes, 3u);
  EXPECT_EQ(pen_changes(plot), 1u);
  PlotRequest named;
  add_pen(named.pens, "%3 note=4");
  EXPECT_FALSE(make_plot(drawing, named).pens.back().pen.skip) << "who names it wants it";
}

/// The time that a device takes never grows, whatever is drawn.
TEST(Plots, TakeNoLongerThanInTheOrderOfTheDrawing) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(5, 95), jitter(-0.03, 0.03);
    std::uniform_int_distribution<int> count(1, 30), kind(0, 4), node(1, 12);
    Drawing drawing;
    for (const char* name : {"1 a", "2 b"}) {
      Layer& layer = drawing.layers.emplace_back(Layer{name, {}});
      const int lines = count(random);
      std::vector<Point2> line;
      for (int i = 0; i < lines; ++i) {
        const int what = kind(random);
        if (what == 0 && !line.empty()) {  // nearly the line before, in part
          for (Point2& p : line) p += Point2{jitter(random), jitter(random)};
          line.resize(std::max<std::size_t>(2, line.size() / 2));
        } else {
          line.clear();
          const int points = count(random) + 1;
          Point2 p{place(random), place(random)};
          for (int k = 0; k < points; ++k) {
            line.push_back(p);
            if (what == 1) p = {node(random) * 8.0, node(random) * 8.0};
            if (what == 2) p = {place(random), place(random)};
            if (what > 2) p += Point2{1, what == 3 ? 0 : jitter(random)};
          }
        }
        layer.lines.add(line);
      }
    }
    for (const char* name : {"grbl-servo", "axidraw-v3", "cutter", "designjet", "hp7475a"}) {
      const Device& device = *find_device(name);
      PlotRequest request;
      request.style.page = {100, 100, 0};
      request.paths.pace = pace_of(device);
      request.paths.tolerances.lift_mm = request.paths.pace.lift_mm();
      request.paths.order.returns = device.returns;
      for (const Optimize how : {Optimize::order, Optimize::join, Optimize::full}) {
        request.paths.optimize = how;
        const auto seconds = [&](const Plot& plot) {
          return plot_seconds(device, measure(plot, {0, 0}, device.returns), pen_changes(plot));
        };
        EXPECT_LE(seconds(make_plot(drawing, request)), seconds(deal_to_pens(drawing, request)) * (1 + 1e-12))
            << seed << " " << name << " " << static_cast<int>(how);
      }
    }
  }
}

TEST(Plots, StrokesOfOnePenKeepTheirLooks) {
  Drawing drawing = layers_of({"1 all", "1 all", "1 all"});
  drawing.layers[0].color = {1, 0, 0};
  drawing.layers[1].color = {0, 0, 1};
  drawing.layers[2].color = {1, 0, 0};
  drawing.layers[2].width_mm = 0.7;
  PlotRequest request;
  request.pen_per_layer = request.keep_looks = true;
  const Plot plot = make_plot(drawing, request);
  ASSERT_EQ(plot.pens.size(), 1u);
  EXPECT_EQ(plot.pens[0].lines.size(), 3u);
  const Drawing pictured = drawing_of(plot);
  ASSERT_EQ(pictured.layers.size(), 3u);
  double red = 0, blue = 0, wide = 0;
  for (const Layer& layer : pictured.layers) {
    EXPECT_EQ(layer.name, "1 all");
    red += layer.color == std::array<double, 3>{1, 0, 0};
    blue += layer.color == std::array<double, 3>{0, 0, 1};
    wide += layer.width_mm == 0.7;
  }
  EXPECT_EQ(red, 2);
  EXPECT_EQ(blue, 1);
  EXPECT_EQ(wide, 1);
  PlotOptions options;
  options.style = styles_of(plot);
  const std::string svg = write_svg(pictured, options);
  EXPECT_NE(svg.find("<g stroke=\"#00f\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("stroke-width=\"0.7\""), std::string::npos) << svg;
}

TEST(Pens, AreReadFromTheCommandLineAndFromAFile) {
  PenTable table;
  add_pen(table, "outline=1,black,0.5");
  add_pen(table, "material:steel=4,#0f0");
  add_pen(table, "rest=2");
  EXPECT_EQ(table.pen_of("outline", ""), 1u);
  EXPECT_EQ(table.pen_of("outline", "steel"), 4u);
  EXPECT_EQ(table.pen_of("mesh", ""), 2u);
  add_pen(table, "object:wheel*=5");
  add_pen(table, "object:wheel 2=6");
  EXPECT_EQ(table.pen_of("outline", "steel", 0, "wheel 1"), 5u);
  EXPECT_EQ(table.pen_of("outline", "steel", 0, "wheel 2"), 6u) << "the last that fits";
  EXPECT_EQ(table.pen_of("outline", "steel", 0, "axle"), 4u);
  EXPECT_EQ(table.pen_of("!5+S30 mine", ""), 5u) << "a layer that another program numbered";
  EXPECT_EQ(table.pen(4).color, (std::array<double, 3>{0, 1, 0}));
  for (const char* wrong : {"", "outline", "=1", "outline=0", "outline=1001", "outline=x", "outline=1,reddish",
                            "outline=1,red,-1", "outline=1,red,0", "outline=1,#12"}) {
    EXPECT_THROW(add_pen(table, wrong), std::invalid_argument) << wrong;
  }
  const PenTable file = read_pens(
      "[[pen]]\nnumber = 2\ncolor = \"red\"\nwidth = 0.7\nclasses = [\"outline\", \"border\"]\nmaterials = [\"glass\"]\nobjects = [\"lid\"]\n"
      "[[pen]]\nnumber = 1\nrest = true\nskip = true\n",
      "pens.toml");
  EXPECT_EQ(file.pen_of("border", ""), 2u);
  EXPECT_EQ(file.pen_of("mesh", "glass"), 2u);
  EXPECT_EQ(file.pen_of("mesh", "", 0, "lid"), 2u);
  EXPECT_EQ(file.pen_of("mesh", ""), 1u);
  EXPECT_TRUE(file.pen(1).skip);
  for (const char* wrong :
       {"", "[[pen]]\n", "[[pen]]\nnumber = 0\n", "[[pen]]\nnumber = 1\nwidth = 0\n", "[[pen]]\nnumber = 1\nwidht = 1\n",
        "[[pen]]\nnumber = 1\n[[pen]]\nnumber = 1\n", "[[pen]]\nnumber = 1\ncolor = \"?\"\n", "[pen]\nnumber = 1\n"}) {
    EXPECT_THROW(read_pens(wrong, "pens.toml"), std::runtime_error) << wrong;
  }
}

TEST(Dashes, BeginAndEndWithADash) {
  Polylines line;
  line.points = {{0, 0}, {10, 0}, {10, 20}};
  line.begin = {0, 3};
  const std::vector<double> pattern{3, 1};
  const Polylines cut = cut_dashes(line, pattern, 0.5);
  ASSERT_GT(cut.size(), 4u);
  EXPECT_EQ(cut[0].front(), Point2(0, 0));
  EXPECT_NEAR(glm::distance(cut[cut.size() - 1].back(), Point2(10, 20)), 0, 1e-9);
  // 8 dashes of 2.5 and 7 gaps of 1.5, pressed or stretched into 30 mm.
  const double stretch = 30 / (7 * 4 + 2.5);
  EXPECT_EQ(cut.size(), 8u);
  const PathLengths lengths = measure(cut, {0, 0}, false);
  EXPECT_NEAR(lengths.down_mm, 8 * 2.5 * stretch, 1e-9);
  // A short line is one dash, and lines without a pattern stay.
  line.points = {{0, 0}, {2, 0}};
  line.begin = {0, 2};
  EXPECT_EQ(cut_dashes(line, pattern, 0.5).size(), 1u);
  EXPECT_EQ(cut_dashes(line, {}, 0.5).points, line.points);
}

TEST(Dashes, PatternsOfSvgAreCutAsTheyAre) {
  Polylines line;
  line.points = {{0, 0}, {10, 0}};
  line.begin = {0, 2};
  const Polylines cut = cut_pattern(line, std::vector<double>{2}, 1);
  // Marks of 2 and gaps of 2 from 1 mm into the first mark: [0,1], [3,5], [7,9].
  ASSERT_EQ(cut.size(), 3u);
  EXPECT_EQ(cut[0][1], Point2(1, 0));
  EXPECT_EQ(cut[1][0], Point2(3, 0));
  EXPECT_EQ(cut[2][1], Point2(9, 0));
  EXPECT_EQ(cut_pattern(line, std::vector<double>{0, 0}, 1).points, line.points);
}

// ---- hp2xx, a reader that is not ours -------------------------------------------------------------------------------

bool hp2xx_is_there() { return std::system("command -v hp2xx >/dev/null 2>&1") == 0; }

/// Points of the paths of hp2xx's SVG, in its units of 1/90 inch.
std::vector<Point2> hp2xx_points(const std::string& hpgl) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("ligne-hp2xx-" + std::to_string(std::hash<std::string>{}(hpgl)));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "in.hpgl", std::ios::binary) << hpgl;
  const std::string command = "cd '" + folder.string() + "' && hp2xx -q -N -t -m svg -f out.svg in.hpgl >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream in(folder / "out.svg");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove_all(folder);
  std::vector<Point2> points;
  for (std::size_t at = text.find("<path d=\""); at != std::string::npos; at = text.find("<path d=\"", at + 1)) {
    std::istringstream data(text.substr(at + 9, text.find('"', at + 9) - at - 9));
    std::string word;
    double x = 0;
    char comma = 0;
    while (data >> word) {
      if (word != "M" && word != "L") continue;
      Point2 p{0, 0};
      if (data >> x >> comma >> p.y) points.push_back({x, p.y});
    }
  }
  return points;
}

class Hp2xx : public testing::TestWithParam<std::string> {};

TEST_P(Hp2xx, ReadsTheSameDrawingOfTheSameSize) {
  if (!hp2xx_is_there()) GTEST_SKIP() << "hp2xx is not installed";
  const Device& device = *find_device(GetParam());
  Drawing drawing = plotter_drawing();
  const Written w = written(device, drawing, true);
  const std::vector<Point2> read = hp2xx_points(w.text);
  ASSERT_FALSE(read.empty());
  // hp2xx takes a unit for 0.025 mm, puts the lower left of the drawing into a corner, and fits its SVG to a page: shapes
  // are compared, at our width. That sizes are true its G-code tells, below.
  constexpr double kUnitMm = 0.025;
  Rect ours, theirs;
  std::vector<Point2> points;
  for (const auto& stroke : test::replay_hpgl(w.text).strokes) {
    for (const Point2 p : stroke) points.push_back(p * kUnitMm);
  }
  for (const Point2 p : points) ours.extend(p);
  Rect pixels;
  for (const Point2 p : read) pixels.extend(p);
  const double pixel_mm = ours.width() / pixels.width();
  for (const Point2 p : read) theirs.extend(p * pixel_mm);
  constexpr double kWithinMm = 0.05;
  EXPECT_NEAR(theirs.height(), ours.height(), kWithinMm);
  const auto nearest = [](Point2 p, const std::vector<Point2>& all) {
    double least = 1e300;
    for (const Point2 q : all) least = std::min(least, glm::distance(p, q));
    return least;
  };
  std::vector<Point2> shifted;
  for (const Point2 p : read)
    shifted.push_back({p.x * pixel_mm - theirs.min.x + ours.min.x, theirs.max.y - p.y * pixel_mm + ours.min.y});
  for (const Point2 p : points) EXPECT_LE(nearest(p, shifted), kWithinMm) << p.x << " " << p.y;
  for (const Point2 p : shifted) EXPECT_LE(nearest(p, points), kWithinMm) << p.x << " " << p.y;
}

INSTANTIATE_TEST_SUITE_P(Devices, Hp2xx, testing::Values("hp7475a", "hp7550a", "designjet", "cutter"));

TEST(Hp2xxGcode, ALineOf25MillimetresIs25Millimetres) {
  if (!hp2xx_is_there()) GTEST_SKIP() << "hp2xx is not installed";
  Drawing drawing;
  add_line(drawing, "outline", {{100, 100}, {125, 100}});
  add_line(drawing, "outline", {{100, 110}, {100, 135}});
  const std::string hpgl = written(*find_device("cutter"), drawing, false).text;
  const auto folder = std::filesystem::temp_directory_path() / "ligne-hp2xx-nc";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "in.hpgl") << hpgl;
  ASSERT_EQ(std::system(("cd '" + folder.string() + "' && hp2xx -q -N -t -m nc -f out.nc in.hpgl >/dev/null 2>&1").c_str()),
            0);
  std::ifstream in(folder / "out.nc");
  std::string line;
  Point2 at{0, 0};
  std::vector<double> lengths;
  while (std::getline(in, line)) {
    double x = 0, y = 0;
    if (std::sscanf(line.c_str(), "G01 X %lf Y %lf", &x, &y) == 2) {
      if (glm::distance(at, Point2(x, y)) > 0.01) lengths.push_back(glm::distance(at, Point2(x, y)));
      at = {x, y};
    } else if (std::sscanf(line.c_str(), "G00 X %lf Y %lf", &x, &y) == 2) {
      at = {x, y};
    }
  }
  std::filesystem::remove_all(folder);
  ASSERT_EQ(lengths.size(), 2u);
  for (const double length : lengths) EXPECT_NEAR(length, 25, 0.01);
}

}  // namespace
}  // namespace ligne
