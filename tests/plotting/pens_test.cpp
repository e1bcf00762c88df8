/// Pens, their labels and looks.

#include "drawing/measures.hpp"
#include "main/script.hpp"
#include "main/tier.hpp"
#include "plotted.hpp"
#include "plotting/plot.hpp"
#include "plotting/plot_parts.hpp"
#include "plotting/tiles.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {
namespace {

using namespace test;

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
  Drawing drawing;
  add_line(
      drawing, "1 all",
      line_of_text("0..1000:10+k/10,60+0.6*sin(k/10) 1001..2001:210.1-k/10,60+0.6*sin(200.1-k/10)+0.03*sin(600.3-k*0.3)"));
  EXPECT_GT(join_strokes(drawing.layers[0].lines, {}).size(), 20u) << "there is something to cut";
  EXPECT_EQ(make_plot(drawing, {}).pens.at(0).lines.size(), 1u);
}

/// Device files: numbers within their bounds, and nothing in braces that would reach the machine.

/// A right file with one key given another value, or added.
std::string device_with(const std::string& language, const std::string& key, const std::string& value) {
  bool found = false;
  std::string text;
  std::ifstream file(LIGNE_SOURCE_DIR "/tests/plotting/own_device-" + language + ".toml");
  for (std::string line; std::getline(file, line);) {
    const std::string name = line.substr(0, line.find(" = "));
    found = found || name == key;
    text += (name == key ? key + " = " + value : line) + "\n";
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

/// "PEN PEN ...: CLASS; MATERIAL; OBJECT", pens as --pen has them, or ": " behind the text of a file: the pen of such a
/// line.
std::string pen_of(const std::string& text, bool is_file) {
  const std::size_t colon = text.rfind(": ");
  const std::string pens = text.substr(0, colon);
  PenTable table;
  if (is_file) table = read_pens(pens, "F");
  for (const std::string& pen : is_file ? std::vector<std::string>() : words_of(pens)) add_pen(table, pen);
  std::vector<std::string> line = parts_of(text.substr(colon + 2), ';');
  line.resize(3);
  const unsigned number = table.pen_of(line[0], line[1], 0, line[2]);
  return std::to_string(number) + (table.pen(number).skip ? " skip" : "");
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
    {"pen-of", [](auto& t) { return pen_of(t, false); }},
    {"pen-of-file", [](auto& t) { return pen_of(t, true); }},
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
    PenLines& lines = plot.pens.emplace_back();
    lines.pen.number = 1;
    lines.pen.speed = 50;
    lines.pen.pause = true;
    lines.lines = lines_of_text("10,10 20,20");
    const Page page{100, 100, 0};
    const std::string commands = write_plot(plot, device, place_on_device(device, page, Rect{{10, 10}, {20, 20}}, false));
    EXPECT_EQ(commands.find_first_of("{}"), std::string::npos) << commands;
    for (const char* begin : {"a", "b", "c", "d", "e", "f", "g"})
      EXPECT_NE(("\n" + commands).find(std::string("\n") + begin), std::string::npos) << begin << " in " << commands;
  }
}

// Long plots: what is cut off, split and done between strokes; sheets of large drawings.

double length(const Plot& plot) {
  double sum = 0;
  for (const PenLines& pen : plot.pens) sum += test::length_of(pen.lines);
  return sum;
}

std::size_t strokes(const Plot& plot) {
  std::size_t n = 0;
  for (const PenLines& pen : plot.pens) n += pen.lines.size();
  return n;
}

/// Two pens; strokes of random length, a dot among them.
Plot random_plot(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(20, 180);
  Plot plot;
  for (const unsigned number : {1u, 3u}) {
    PenLines pen;
    pen.pen.number = number;
    for (int i = 0; i < 20; ++i) {
      std::vector<Point2> line;
      for (int k = 0; k < 1 + i % 5; ++k) line.push_back({place(random), place(random)});
      pen.lines.add(line);
    }
    plot.pens.push_back(std::move(pen));
  }
  return plot;
}

TEST(PlotParts, PartsAreTheWholeAndNoneIsTooLarge) {
  const Device& device = *find_device("grbl-servo");
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Plot plot = random_plot(seed);
    for (const PlotSplit split :
         {PlotSplit{SplitBy::lifts, 7}, PlotSplit{SplitBy::distance, 900}, PlotSplit{SplitBy::time, 45}}) {
      const std::vector<Plot> parts = split_plot(plot, split, &device, {0, 0});
      EXPECT_GT(parts.size(), 2u);
      std::size_t count = 0;
      double way = 0;
      for (const Plot& part : parts) {
        count += strokes(part);
        way += length(part);
        if (strokes(part) == 1) continue;
        if (split.by == SplitBy::lifts) {
          EXPECT_LE(strokes(part), 7u);
        } else if (split.by == SplitBy::distance) {
          EXPECT_LE(length(part), 900 + 1e-9);
        }
      }
      EXPECT_EQ(count, strokes(plot));
      EXPECT_NEAR(way, length(plot), 1e-9);
    }
  }
}

TEST(PlotParts, TheWholeTimeIsThatOfTheReport) {
  const Device& device = *find_device("hp7475a");
  const Plot plot = random_plot(1);
  const double seconds = plot_seconds(device, measure(plot, {0, 0}, false), pen_changes(plot));
  EXPECT_EQ(strokes_within(plot, device, {0, 0}, seconds + 1e-6), strokes(plot));
  EXPECT_EQ(strokes_within(plot, device, {0, 0}, seconds - 1e-6), strokes(plot) - 1);
  EXPECT_EQ(strokes_within(plot, device, {0, 0}, 0), 0u);
}

TEST(PlotParts, ABrushNeverDrawsMoreThanItHolds) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Plot plot = random_plot(seed);
    const Plot dipped = with_actions(plot, 250);
    EXPECT_NEAR(length(dipped), length(plot), 1e-6);
    double since = 0;
    for (const PenLines& pen : dipped.pens) {
      for (std::uint32_t i = 0; i < pen.lines.size(); ++i) {
        if (std::ranges::binary_search(pen.actions, i)) since = 0;
        Polylines one;
        one.add(pen.lines[i]);
        since += test::length_of(one);
        EXPECT_LE(since, 250 + 1e-9);
      }
    }
    EXPECT_EQ(dipped.pens[0].actions.front(), 0u) << "it is dipped before the first stroke";
  }
}

TEST(Tiles, SheetsTogetherAreTheDrawing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0, 500), y(0, 330);
  Drawing drawing;
  drawing.layers.push_back({"mesh", {}});
  for (int i = 0; i < 60; ++i)
    drawing.layers[0].lines.add(std::array{Point2{x(random), y(random)}, Point2{x(random), y(random)}});
  const Page whole{500, 330}, paper{210, 297, 10};
  // Without an overlap every bit of line is on one sheet.
  double sum = 0;
  const std::vector<Tile> tiles = cut_into_tiles(drawing, whole, paper, 0);
  ASSERT_EQ(tiles.size(), 6u);
  for (const Tile& tile : tiles) {
    for (const Layer& layer : tile.drawing.layers) {
      if (layer.name != "mesh") continue;
      sum += test::length_of(layer.lines);
      for (const Point2 p : layer.lines.points)
        EXPECT_TRUE(std::abs(p.x - 105) <= 95 + 1e-9 && std::abs(p.y - 148.5) <= 138.5 + 1e-9) << p.x << " " << p.y;
    }
    EXPECT_EQ(tile.drawing.layers.back().name, "register");
  }
  EXPECT_NEAR(sum, test::length_of(drawing.layers[0].lines), 1e-6);
}

TEST(Tiles, MarksOfNeighboursAreOnePointOfTheDrawing) {
  Drawing drawing;
  drawing.layers.push_back({"mesh", {}});
  drawing.layers[0].lines.add(std::array{Point2{1, 50}, Point2{299, 50}});
  const std::vector<Tile> tiles = cut_into_tiles(drawing, {300, 100}, {160, 120, 10}, 8);
  ASSERT_EQ(tiles.size(), 3u);
  // Marks begin with the upper left cross, across and down; the upper right one follows two crosses later.
  const auto middle = [](const Polylines& lines, std::size_t i) { return (lines[i].front() + lines[i].back()) * 0.5; };
  const Polylines &left = tiles[0].drawing.layers.back().lines, &right = tiles[1].drawing.layers.back().lines;
  const double step = 140 - 8;
  EXPECT_NEAR(middle(left, 4).x - 10, middle(right, 0).x - 10 + step, 1e-9);
  EXPECT_EQ(middle(left, 4).y, middle(right, 0).y);
}

}  // namespace
}  // namespace ligne
