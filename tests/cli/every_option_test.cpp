/// Every option of the commands that draw, in every format: it changes what is written, or is refused, or is warned of.

#include <nlohmann/json.hpp>

#include "main/tier.hpp"
#include "program.hpp"
#include "scene/tiff_builder.hpp"

namespace ligne::test {
namespace {

using Json = nlohmann::json;

/// The first tier takes one row in so many.
constexpr std::size_t kRowsByChosen = 8;

Words words(std::string_view text) { return std::string(text).c_str(); }

/// A line of every_option.txt.
struct OptionRow {
  std::string option, value, beside, silent_formats, reason;
};

std::vector<OptionRow> rows_of(const std::string& command) {
  std::vector<OptionRow> rows;
  std::ifstream file(LIGNE_SOURCE_DIR "/tests/cli/every_option.txt");
  std::string section;
  const auto taken = [](std::string& rest, const std::string& end) {
    const std::size_t at = std::min(rest.find(end), rest.size());
    const std::string part = rest.substr(0, at);
    rest.erase(0, at + end.size());
    return part.substr(0, part.find_last_not_of(' ') + 1);
  };
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("== ")) section = line.substr(3);
    if (!line.starts_with("-") || section != command) continue;
    OptionRow& row = rows.emplace_back();
    std::string first = taken(line, " |");
    row.option = taken(first, " ");
    row.value = first;
    if (line.starts_with(' ')) line.erase(0, 1);
    row.beside = taken(line, "|");
    if (line.starts_with(' ')) line.erase(0, 1);
    row.silent_formats = taken(line, ": ");
    row.reason = line;
  }
  return rows;
}

/// A prism over a regular polygon, with its axis upright.
Json prism(const std::string& name, int sides, double radius, double x, double bottom, double top) {
  Json vertices = Json::array(), faces = Json::array(), lower = Json::array(), upper = Json::array();
  constexpr double kTurn = 6.283185307179586;
  for (const double z : {bottom, top})
    for (int k = 0; k < sides; ++k)
      vertices.push_back({x + radius * std::cos(kTurn * k / sides), radius * std::sin(kTurn * k / sides), z});
  for (int k = 0; k < sides; ++k) {
    const int next = (k + 1) % sides;
    faces.push_back({{"outer", {k, next, sides + next, sides + k}}});
    lower.push_back(sides - 1 - k);
    upper.push_back(sides + k);
  }
  faces.push_back({{"outer", lower}});
  for (int k = 1; k + 1 < sides; ++k) faces.push_back({{"outer", {sides, sides + k, sides + k + 1}}});
  return {{"name", name}, {"vertices", vertices}, {"faces", faces}};
}

/// A box, another that runs into it, and a pipe.
std::string scene_text() {
  Json pipe = prism("pipe", 24, 4, 12, 0, 9);
  return Json{{"format", "ligne-scene"},
              {"version", 1},
              {"objects", {prism("box", 4, 5, 0, 0, 8), prism("stone", 4, 4, 3, 4, 11), pipe}}}
      .dump();
}

constexpr std::string_view kFilledDrawing =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40">
<g fill="none" stroke="black" stroke-width="0.4">
<path d="M5 5H20M20.5 5H30V20M3 9l1 .1l1 0l1 -.1l8 0"/><circle cx="20" cy="22" r="8"/><path d="M2 2l4 0"/></g>
<path d="M10 10h20v20h-20z" fill="red"/><text x="3" y="3">t</text></svg>
)";

constexpr std::string_view kTwoPens = R"([[pen]]
number = 1
width = 0.5
classes = ["outline"]
[[pen]]
number = 2
width = 0.2
rest = true
)";

class EveryOption : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("scene.json", scene_text());
    write("drawing.svg", kFilledDrawing);
    write("pens.toml", kTwoPens);
    write("points.csv", "1,1\n2,3\n");
    write("way.csv", "60,90,90\n0,90,60\n");
    std::string grid = "ncols 7\nnrows 6\nxllcorner 0\nyllcorner 0\ncellsize 2\n", scattered;
    for (int i = 0; i < 6; ++i) {
      for (int k = 0; k < 7; ++k) {
        const std::string height = std::to_string(3 * std::sin(i) * std::cos(k));
        grid += height + ' ';
        scattered += std::to_string(i + 0.3 * std::sin(k)) + ',' + std::to_string(k + 0.2 * i) + ',' + height + '\n';
      }
      grid += '\n';
    }
    write("grid.asc", grid);
    write("scattered.csv", scattered);
    write("table.csv", "x,y,z\n0,0,1\n1,0,2\n2,0,2\n0,1,3\n1,1,4\n2,1,9\n");
    write("sets.dat", "0 0 1\n1 0 2\n\n0 1 3\n1 1 4\n\n\n5 5 1\n6 5 2\n\n5 6 3\n6 6 9\n");
    const std::vector<float> bands{1, 4, 2, 1, 3, 5, 4, 2, 5, 9, 1, 3, 2, 2, 8, 1, 1, 7};
    write("bands.tif", height_test::TiffBuilder(3, 3, bands, 3, 2).bytes());
    write("own.toml", contents(std::filesystem::path(LIGNE_SOURCE_DIR) / "plotting/devices/hp7470a.toml"));
    run("draw scene.json --lines 32 --page 60x60 --zbuffer-save kept.zb -o kept.svg");
    std::filesystem::remove(file("kept.svg"));
  }

  /// All that a command line writes; nothing where it is refused. The files are taken away.
  std::optional<std::string> result_of(const Words& arguments) const {
    const std::vector<std::string> before = new_files();
    const Outcome outcome = run(arguments);
    std::string result = outcome.out + outcome.err;
    for (const std::string& name : new_files()) {
      if (std::ranges::find(before, name) != before.end()) continue;
      result += name + contents(file(name));
      std::filesystem::remove(file(name));
    }
    if (outcome.status != kDone) return std::nullopt;
    return result;
  }

  /// The formats in which the option does nothing and is not warned of, beside others or alone.
  std::string silent_formats(const Words& command, std::string_view formats, const OptionRow& row) {
    std::string silent;
    for (const std::string& format : words(formats)) {
      bool is_silent = false;
      for (const std::string& beside : {row.beside, std::string()}) {
        Words line = command;
        line += words(beside);
        add_small_page(line, row.option, format);
        const std::string whole_line = row.option + ' ' + beside;
        const bool in_parts = whole_line.find("--tile") != whole_line.npos || whole_line.find("--frames") != whole_line.npos;
        line += {"-o", (in_parts ? "out%d." : "out.") + format};
        const std::optional<std::string> without = result_of(line);
        line.emplace_back(row.option);
        line += words(row.value);
        const std::optional<std::string> with = result_of(line);
        is_silent = is_silent || (with && with == without);
        if (row.beside.empty()) break;
      }
      if (is_silent) silent += (silent.empty() ? "" : " ") + format;
    }
    return silent;
  }

  void expect_words_or_deeds(const Words& command, std::string_view formats) {
    const std::vector<OptionRow> rows = rows_of(command.front());
    const std::vector<std::string> listed = options_of(command.front());
    EXPECT_GT(listed.size(), 20u);
    for (const std::string& option : listed)
      EXPECT_TRUE(std::ranges::any_of(rows, [&](const OptionRow& row) { return row.option == option; }))
          << command.front() << ' ' << option << " has no row";
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (!is_chosen("every option", k, kRowsByChosen)) continue;
      EXPECT_EQ(rows[k].silent_formats.empty(), rows[k].reason.empty());
      std::string silent = silent_formats(command, formats, rows[k]);
      if (rows[k].silent_formats == silent + '?') silent += '?';
      if (rows[k].silent_formats.ends_with('?') && silent.empty()) continue;
      EXPECT_EQ(silent, rows[k].silent_formats) << command.front() << ' ' << rows[k].option;
    }
  }

 private:
  /// The last name of each option in the help, but for those that say where and how to write.
  std::vector<std::string> options_of(const std::string& command) const {
    std::vector<std::string> names;
    std::istringstream help(run({"help", command, "all"}).out);
    for (std::string line; std::getline(help, line);) {
      if (!line.starts_with("  -")) continue;
      std::string name = words(line).front();
      name = name.substr(name.rfind(',') + 1);
      if (name != "--help" && name != "--output" && name != "--format") names.push_back(name);
    }
    return names;
  }

  /// Small pages and few curves, as far as the line does not choose them, and the option does not.
  static void add_small_page(Words& line, std::string_view option, std::string_view format) {
    if (line.front() == "plot") return;
    std::vector<std::pair<std::string, std::string>> small = {{"--page", "60x60"}, {"--dpi", "40"}};
    if (line.front() == "surface") small.insert(small.end(), {{"-x", "-5:5:9"}, {"-y", "-5:5:9"}});
    for (const auto& [name, value] : small) {
      if (name == option || std::ranges::find(line, name) != line.end()) continue;
      if (name == "--dpi" && format != "png") continue;
      line += {name, value};
    }
  }
};

TEST_F(EveryOption, OfDrawDoesSomethingOrIsToldOf) {
  expect_words_or_deeds({"draw", "scene.json"}, "svg pdf png hpgl gcode json");
}
TEST_F(EveryOption, OfSurfaceDoesSomethingOrIsToldOf) {
  expect_words_or_deeds({"surface", "x*x*y/20"}, "svg pdf png hpgl gcode json");
}
TEST_F(EveryOption, OfPlotDoesSomethingOrIsToldOf) {
  expect_words_or_deeds({"plot", "drawing.svg"}, "svg pdf png hpgl gcode");
}

}  // namespace
}  // namespace ligne::test
