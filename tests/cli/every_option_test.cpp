/// Every option of the commands that draw, in every format: it changes what is written, or is refused, or is warned of.

#include "main/tier.hpp"
#include "program.hpp"

namespace ligne::test {
namespace {

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

class EveryOption : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    // A box, another that runs into it, and a pipe; a drawing, pens, and grids of all kinds.
    std::filesystem::copy(LIGNE_SOURCE_DIR "/tests/cli/every_option", folder_);
    write("own.toml", contents(std::filesystem::path(LIGNE_SOURCE_DIR) / "plotting/devices/hp7470a.toml"));
    run("draw scene.json --lines 32 --page 60x60 --zbuffer-save kept.zb -o kept.svg");
    std::filesystem::remove(file("kept.svg"));
  }

  /// All that a command line writes; nothing where it is refused. The files are taken away.
  std::optional<std::string> result_of(const Words& arguments) const {
    const std::vector<std::string> before = new_files();
    const Outcome outcome = run(arguments);
    std::string result = outcome.out + outcome.err;
    // Slow machines show the progress.
    if (const std::size_t bar = result.find('\r'); bar != result.npos) result.erase(bar, result.rfind("\x1b[K") + 3 - bar);
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
