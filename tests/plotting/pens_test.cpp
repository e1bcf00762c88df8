/// Pens, their labels and looks.

#include "main/script.hpp"
#include "main/tier.hpp"
#include "plotted.hpp"

namespace ligne {
namespace {

using namespace test;

TEST(Pens, ThatTheDeviceDoesNotHoldAreRefused) {
  PlotRequest request;
  add_pen(request.pens, "rest=7");
  const Drawing drawing = plotter_drawing();
  const Device& device = *find_device("hp7475a");
  const DeviceFrame frame = place_on_device(device, {}, drawn_bounds(drawing), false);
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

/// Layers that are numbered for other pens do not change the pen that draws the rest.
TEST(Pens, TheRestIsOnePenWhateverTheLayersAreNumbered) {
  const Drawing drawing = layers_of({"1-Black", "2-Red"});
  PlotRequest request;
  add_pen(request.pens, "rest=1");
  const Device& device = *find_device("grbl-servo");
  const DeviceFrame frame = place_on_device(device, {}, drawn_bounds(drawing), false);
  request.paths.order.home = frame.to_page({0, 0});
  request.paths.order.returns = device.returns;
  const Plot plot = make_plot(drawing, request);
  ASSERT_EQ(plot.pens.size(), 1u);
  EXPECT_EQ(pen_changes(plot), 0u);
  const std::string gcode = write_plot(plot, device, frame);
  expect_no_parts(gcode, {"M0"});
  const Replay machine = replay(device, gcode);
  ASSERT_EQ(machine.strokes.size(), 2u);
  EXPECT_TRUE(machine.pens.empty());
  Point2 at{0, 0};
  double raised = 0;
  for (const std::vector<Point2>& stroke : machine.strokes) {
    raised += glm::distance(at, stroke.front());
    at = stroke.back();
  }
  raised += device.returns ? glm::distance(at, Point2{0, 0}) : 0;
  EXPECT_NEAR(measure_in_turn(plot, frame.to_page({0, 0}), device.returns).up_mm, raised, 0.01)
      << "the report is of the file";
}

TEST(Pens, WhatLayersSayOfPensIsDone) {
  const Drawing drawing = layers_of({"2+D250+S50 slow", "%3 note", "!2 again", "1"});
  const Plot plot = make_plot(drawing, {});
  const Device& grbl = *find_device("grbl-servo");
  const std::string gcode = write_plot(plot, grbl, place_on_device(grbl, {}, drawn_bounds(plot), false));
  EXPECT_EQ(gcode.find("pen 3"), std::string::npos) << "not plotted";
  expect_parts(gcode, {"M0 (pen 2: slow)\nG4 P0.25\n"});
  EXPECT_NE(gcode.find("G1 F1200"), std::string::npos) << "half its speed";
  EXPECT_NE(gcode.find("M0 (pen 2: again)\n"), std::string::npos) << "a pause";
  const Device& hp = *find_device("cutter");
  const std::string hpgl = write_plot(plot, hp, place_on_device(hp, {}, drawn_bounds(plot), false));
  expect_no_parts(hpgl, {"SP3"});
  expect_parts(hpgl, {"SP2;\nVS5;"});
  EXPECT_EQ(hpgl.find("SP2", hpgl.find("SP2") + 1), std::string::npos) << "it is held already";
  EXPECT_NE(hpgl.find("VS10;"), std::string::npos) << "as fast as usual again";
  EXPECT_EQ(measure(plot, {0, 0}, false).strokes, 3u);
  EXPECT_EQ(pen_changes(plot), 1u);
  PlotRequest named;
  add_pen(named.pens, "%3 note=4");
  EXPECT_FALSE(make_plot(drawing, named).pens.back().pen.skip) << "who names it wants it";
}

/// A cutter cuts holes before what is round them, also where the order of the drawing would take less time.
TEST(Plots, OfCuttersHaveHolesFirst) {
  const Device& cutter = *find_device("cutter");
  Drawing drawing;
  drawing.layers.push_back({"1 red", {}});
  const auto add_square = [&](Point2 at, double side) {
    drawing.layers[0].lines.add(
        std::vector<Point2>{at, at + Point2{side, 0}, at + Point2{side, side}, at + Point2{0, side}, at});
  };
  for (const double x : {5.0, 105.0}) {
    add_square({x, 5}, 90);
    add_square({x + 70, 20}, 10);
    add_square({x + 70, 60}, 10);
  }
  for (const bool cuts : {true, false}) {
    PlotRequest request;
    request.paths.order.inside_first = cuts && cutter.inside_first;
    const Plot plot = make_plot(drawing, request);
    ASSERT_EQ(plot.pens.size(), 1u);
    const Polylines& lines = plot.pens[0].lines;
    ASSERT_EQ(lines.size(), 6u);
    int outside_first = 0;
    std::array<bool, 2> is_cut{};
    for (std::size_t i = 0; i < lines.size(); ++i) {
      Rect box;
      for (const Point2 p : lines[i]) box.extend(p);
      bool& outer = is_cut[box.min.x < 100 ? 0 : 1];
      outside_first += outer;
      outer |= box.width() > 50;
    }
    EXPECT_EQ(outside_first == 0, cuts) << "without a cutter the order comes about otherwise";
  }
}

/// The time that a device takes never grows, whatever is drawn.
TEST(Plots, TakeNoLongerThanInTheOrderOfTheDrawing) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    if (!test::is_chosen("plots", seed, 4)) continue;
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
      request.paths.order.returns = device.returns;
      for (const Optimize how : {Optimize::order, Optimize::join, Optimize::full}) {
        request.paths.optimize = how;
        const auto seconds = [&](const Plot& plot) {
          return plot_seconds(device, measure(plot, {0, 0}, device.returns), pen_changes(plot));
        };
        EXPECT_LE(seconds(make_plot(drawing, request)), seconds(assign_pens(drawing, request)) * (1 + 1e-12))
            << seed << " " << name << " " << static_cast<int>(how);
      }
    }
  }
}

/// A line that comes back along itself and crosses itself at very small angles: drawing nothing twice would take longer.
TEST(Plots, ASquiggleThatTouchesItselfStaysOneStroke) {
  std::vector<Point2> squiggle;
  for (int k = 0; k <= 1000; ++k) squiggle.push_back({10 + k * 0.1, 60 + 0.6 * std::sin(k * 0.1)});
  for (int k = 1000; k >= 0; --k)
    squiggle.push_back({10 + k * 0.1, 60 + 0.6 * std::sin(k * 0.1) + 0.03 * std::sin(k * 0.3)});
  Drawing drawing = layers_of({"1 all"});
  drawing.layers[0].lines = polylines_of({squiggle});
  EXPECT_GT(join_strokes(drawing.layers[0].lines, {}).size(), 20u) << "there is something to cut";
  EXPECT_EQ(make_plot(drawing, {}).pens.at(0).lines.size(), 1u);
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
  expect_parts(svg, {"<g stroke=\"#00f\"", "stroke-width=\"0.7\""});
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
  EXPECT_EQ(table.pen_of("!5+S30 mine", ""), 2u) << "rest is all that no other pen has";
  EXPECT_EQ(PenTable().pen_of("!5+S30 mine", ""), 5u) << "a layer that another program numbered";
  EXPECT_EQ(table.pen(4).color, (std::array<double, 3>{0, 1, 0}));
  const PenTable file = read_pens(
      "[[pen]]\nnumber = 2\ncolor = \"red\"\nwidth = 0.7\nclasses = [\"outline\", \"border\"]\nmaterials = "
      "[\"glass\"]\nobjects = [\"lid\"]\n"
      "[[pen]]\nnumber = 1\nrest = true\nskip = true\n",
      "pens.toml");
  EXPECT_EQ(file.pen_of("border", ""), 2u);
  EXPECT_EQ(file.pen_of("mesh", "glass"), 2u);
  EXPECT_EQ(file.pen_of("mesh", "", 0, "lid"), 2u);
  EXPECT_EQ(file.pen_of("mesh", ""), 1u);
  EXPECT_TRUE(file.pen(1).skip);
}

TEST(Pens, AnotherPenIsNotHomeInBetween) {
  Drawing drawing;
  add_line(drawing, "1-Black", {{10, 10}, {90, 10}});
  add_line(drawing, "2-Red", {{10, 20}, {90, 20}});
  const Plot plot = assign_pens(drawing, {});
  EXPECT_EQ(plot.pens.size(), 2u);
  EXPECT_NEAR(measure_in_turn(plot, {0, 0}, true).up_mm, std::hypot(10, 10) + std::hypot(80, 10) + std::hypot(90, 20), 1e-9);
}

/// Device files: numbers within their bounds, and nothing in braces that would reach the machine.

/// A right file with one key given another value, or added.
std::string device_with(const std::string& language, const std::string& key, const std::string& value) {
  const bool hpgl = language == "hpgl";
  std::vector<std::pair<std::string, std::string>> keys{{"name", "\"own\""},
                                                        {"title", "\"Own\""},
                                                        {"language", "\"" + language + "\""},
                                                        {"step", "0.025"},
                                                        {"limits", "[0, 0, 500, 500]"},
                                                        {"travel", hpgl ? "\"U{x},{y};\"" : "\"G0 X{x} Y{y}\""},
                                                        {"draw", hpgl ? "\"D{points};\"" : "\"G1 X{x} Y{y}\""},
                                                        {"dot", "\"D;\""},
                                                        {"speed_down", "10"},
                                                        {"speed_up", "20"},
                                                        {"lift_seconds", "0.5"},
                                                        {"pen_change_seconds", "30"}};
  bool found = false;
  std::string text;
  for (auto& [name, own] : keys) {
    if (name == key) own = value, found = true;
    text += name + " = " + own + "\n";
  }
  return found || key.empty() ? text : text + key + " = " + value + "\n";
}

std::string words_of_label(const LayerLabel& label) {
  std::string words = std::to_string(label.number) + (label.skip ? " skip" : "") + (label.pause ? " pause" : "");
  if (label.speed) words += " speed " + std::to_string(*label.speed);
  if (label.height) words += " height " + std::to_string(*label.height);
  if (label.delay_ms) words += " delay " + std::to_string(*label.delay_ms);
  return words + (label.name.empty() ? "" : ": " + label.name);
}

/// A device file with a paper of the given lines, and without limits of its own.
std::string device_with_paper(const std::string& paper) {
  std::string text = device_with("hpgl", "", "");
  text.erase(text.find("limits"), text.find('\n', text.find("limits")) + 1 - text.find("limits"));
  return text + "[[paper]]\nname = \"p\"\n" + paper;
}

/// "KEY = VALUE" as a key of the device file.
std::string read_with(const std::string& language, const std::string& text) {
  const std::size_t equals = text.find(" = ");
  read_device(device_with(language, text.substr(0, equals), text.substr(equals + 3)), "F");
  return "read";
}

/// The functions of device_values/.
const TextFunctions kDeviceFunctions{
    {"label", [](auto& t) { return words_of_label(parse_layer_label(t)); }},
    {"pen",
     [](auto& t) {
       PenTable table;
       add_pen(table, t);
       return "read";
     }},
    {"pens", [](auto& t) { return read_pens(t, "F"), "read"; }},
    {"paper", [](auto& t) { return read_device(device_with_paper(t), "F"), "read"; }},
    {"device", [](auto& t) { return read_device(t, "my.toml"), "read"; }},
    {"hpgl", [](auto& t) { return read_with("hpgl", t); }},
    {"gcode", [](auto& t) { return read_with("gcode", t); }},
};

[[maybe_unused]] const bool device_values_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/plotting/device_values", kDeviceFunctions);

TEST(DeviceFile, NoTimeWithinTheBoundsOverflows) {
  Device device = read_device(device_with("hpgl", "speed_down", "0.01"), "F");
  device.up_mm_s = 0.01;
  device.lift_s = 600;
  device.pen_change_s = 86400;
  const std::size_t strokes = std::size_t{1} << 32;
  const double farthest = static_cast<double>(strokes) * 2e6 * std::sqrt(2);
  EXPECT_LT(plot_seconds(device, {strokes, farthest, farthest}, 1000), 9e18);
}

/// The writer replaces every placeholder that the reader lets pass.
TEST(DeviceFile, EveryKnownPlaceholderIsReplaced) {
  for (const std::string language : {"hpgl", "gcode"}) {
    const bool hpgl = language == "hpgl";
    std::string text = device_with(language, "travel", "\"a{x}{y}\"");
    text.erase(text.find("draw"), text.find('\n', text.find("draw")) + 1 - text.find("draw"));
    text += hpgl ? "draw = \"b{points}\"\n" : "draw = \"b{x}{y}{feed}\"\n";
    text +=
        "begin = [\"c{paper}\"]\ndown = [\"d{feed}{z_feed}\"]\npen_change = [\"e{pen}{name}\"]\npen_select = "
        "\"f{pen}{width}\"\n"
        "velocity = \"g{cm_per_s}\"\npens = 0\n";
    const Device device = read_device(text, "F");
    Plot plot;
    PenLines lines;
    lines.pen.number = 1;
    lines.pen.speed = 50;
    lines.pen.pause = true;
    lines.lines.points = {{10, 10}, {20, 20}};
    lines.lines.begin.push_back(2);
    plot.pens.push_back(lines);
    const Page page{100, 100, 0};
    const std::string commands = write_plot(plot, device, place_on_device(device, page, Rect{{10, 10}, {20, 20}}, false));
    EXPECT_EQ(commands.find_first_of("{}"), std::string::npos) << commands;
    for (const char* begin : {"a", "b", "c", "d", "e", "f", "g"})
      EXPECT_NE(("\n" + commands).find(std::string("\n") + begin), std::string::npos) << begin << " in " << commands;
  }
}

}  // namespace
}  // namespace ligne
