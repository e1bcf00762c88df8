#include "cli/command_line.hpp"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/options/options.hpp"
#include "files/closest_name.hpp"
#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "picture/models/memory.hpp"
#include "picture/parse/parse.hpp"
#include "plotting/writers/output_file.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Layout of help texts.

/// The common options of a command. Its short help lists only these.
struct CommonOptions {
  std::string_view command;
  std::vector<std::string_view> names;
};
inline const CommonOptions kCommonOptions[] = {
    {"draw", {"help",      "edges", "crease", "hidden", "quality", "profile", "method", "only",   "hide",  "view",
              "direction", "eye",   "target", "fov",    "frames",  "fill",    "light",  "hatch",  "page",  "landscape",
              "margin",    "scale", "output", "format", "dpi",     "device",  "pens",   "report", "quiet", "pen-width"}},
    {"surface",
     {"help",      "grid",   "parametric", "x",      "y",         "lines",          "z-range", "aspect", "every",
      "contours",  "points", "curve",      "colors", "ridgeline", "contour-labels", "hatch",   "fill",   "hidden",
      "azimuth",   "view",   "elevation",  "axes",   "x-label",   "y-label",        "z-label", "page",   "margin",
      "pen-width", "output", "format",     "dpi",    "device",    "pens",           "quiet",   "title",  "outline"}},
    {"plot", {"help",      "skip",   "fill",     "occlude", "hatch",  "hatch-spacing", "hatch-angle", "page",
              "landscape", "margin", "scale",    "tile",    "output", "dpi",           "device",      "pens",
              "format",    "pen",    "optimize", "report",  "split",  "preview",       "quiet",       "pen-width"}}};

/// Formats "--fov DEG [35]   meaning", with the default in brackets. Exclusions between options are left to the error
/// messages. Wraps text at kWidth columns.
class HelpFormatter : public CLI::Formatter {
 public:
  /// `all`: lists every option of a command, not only the common ones.
  explicit HelpFormatter(bool all) : all_(all) { column_width(kColumn); }

  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text;
    if (option->get_type_size() != 0) {
      if (!option->get_type_name().empty()) text += " " + option->get_type_name();
      if (!option->get_default_str().empty()) text += " [" + option->get_default_str() + "]";
    }
    if (option->get_expected_max() >= CLI::detail::expected_max_vector_size) text += "...";
    return text;
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    std::string line = "  " + make_option_name(option, is_positional) + make_option_opts(option);
    std::string text;
    std::size_t column = line.size();
    const auto begin_line = [&] {
      text += line + '\n';
      line.assign(kColumn, ' ');
      column = kColumn;
    };
    if (column >= kColumn) begin_line();
    line.resize(kColumn, ' ');
    column = kColumn;
    std::istringstream words(make_option_desc(option));
    for (std::string word; words >> word;) {
      if (column > kColumn && column + 1 + word.size() > kWidth) begin_line();
      if (column > kColumn) line += ' ';
      line += word;
      column = line.size();
    }
    return text + line + '\n';
  }

  std::string make_group(std::string group, bool is_positional, std::vector<const CLI::Option*> options) const override {
    if (!is_positional && common_) {
      std::erase_if(options, [&](const CLI::Option* option) { return is_left_out(option); });
      if (options.empty()) return {};
    }
    // Leaves one blank line between groups, not two.
    const bool follows_a_group = !is_positional && group != "Options";
    const std::string text = CLI::Formatter::make_group(std::move(group), is_positional, std::move(options));
    return follows_a_group && text.starts_with('\n') ? text.substr(1) : text;
  }

  std::string make_footer(const CLI::App* app) const override {
    if (!common_) return CLI::Formatter::make_footer(app);
    const std::vector<const CLI::Option*> options = app->get_options();
    const auto rest = std::ranges::count_if(options, [&](const CLI::Option* option) { return is_left_out(option); });
    return "\n" + std::to_string(rest) + " more options: ligne help " + app->get_name() + " all\n" +
           CLI::Formatter::make_footer(app);
  }

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    const auto* const common = std::ranges::find(kCommonOptions, app->get_name(), &CommonOptions::command);
    common_ = all_ || common == std::end(kCommonOptions) ? nullptr : common;
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    // Removes the blank lines of omitted groups.
    for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
    return text;
  }

 private:
  static constexpr std::size_t kColumn = 30, kWidth = 110;

  bool is_left_out(const CLI::Option* option) const {
    const std::vector<std::string>& names = option->get_lnames().empty() ? option->get_snames() : option->get_lnames();
    return !option->get_positional() && std::ranges::find(common_->names, names.front()) == common_->names.end();
  }

  bool all_;
  mutable const CommonOptions* common_ = nullptr;  ///< common options of the current command; null: lists all
};

constexpr int kDone = 0, kFailed = 1, kUsage = 2;

constexpr const char* kFooter =
    R"help(ligne help COMMAND lists the common options of a command; ligne help COMMAND all lists every option.

Examples:
  ligne draw gearbox.obj -o gearbox.svg
  ligne surface "sin(r)/r" -x -12:12 -y -12:12 -o sombrero.svg
  ligne plot sombrero.svg --device hp7475a -o sombrero.hpgl
  ligne info gearbox.obj
  ligne compare gearbox.obj --html gearbox.html
  ligne methods
  ligne study --list)help";

bool is_option(std::string_view word) { return word.size() > 1 && word.front() == '-'; }

std::string command_of_suffix(const std::string& word) {
  constexpr std::pair<std::string_view, std::string_view> kCommands[] = {
      {".obj", "draw"},           {".stl", "draw"},           {".ply", "draw"},           {".gltf", "draw"},
      {".glb", "draw"},           {".json", "draw"},          {".tree", "draw"},          {".svg", "plot"},
      {".asc", "surface --grid"}, {".csv", "surface --grid"}, {".tif", "surface --grid"}, {".tiff", "surface --grid"},
      {".png", "surface --grid"}, {".pgm", "surface --grid"}, {".hgt", "surface --grid"}};
  const std::string suffix = lower_case(std::filesystem::path(word).extension().string());
  for (const auto& [known, command] : kCommands) {
    if (suffix == known) return std::string(command);
  }
  return {};
}

std::vector<std::string_view> names_of_commands(const CLI::App& app) {
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

/// Lists the words of the command line that no option accepts, and suggests similar options.
std::string complaint_about_extras(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  const std::vector<std::string_view> options(names.begin(), names.end());
  const std::vector<std::string> extras = app.remaining(true);
  if (chosen.empty() && !extras.empty() && !is_option(extras.front())) {
    const std::string& file = extras.front();
    if (const std::string meant = command_of_suffix(file); !meant.empty()) {
      return "there is no command " + printable(file, kLongestPath) + "; for a file: ligne " + meant + " " +
             printable(file, kLongestPath) + " -o FILE";
    }
  }
  std::string text;
  for (const std::string& extra : extras) {
    const MethodParameter* parameter = extra.starts_with("--") ? find_parameter(extra.substr(2)) : nullptr;
    if (parameter && parameter->is_experiment) {
      text += ' ' + extra + " (--set " + extra.substr(2) + "=VALUE?)";
      continue;
    }
    text += ' ' + extra + (is_option(extra) ? suggestion(extra, options) : suggestion(extra, names_of_commands(command)));
  }
  return "unknown:" + text + "; see " + (chosen.empty() ? "ligne" : "ligne " + command.get_name()) + " --help";
}

/// The text of CLI11's error in the program's words.
std::string complaint(const CLI::ParseError& e, const CLI::App& app) {
  if (dynamic_cast<const CLI::ExtrasError*>(&e)) return complaint_about_extras(app);
  // A misspelled option is more often the cause than a missing argument.
  if (dynamic_cast<const CLI::RequiredError*>(&e) && std::ranges::any_of(app.remaining(true), is_option)) {
    return complaint_about_extras(app);
  }
  std::string text = e.what();
  const std::size_t colon = text.find(": ");
  if (colon == std::string::npos) return text;
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&e)) {
    const bool repeated = text.find("At Most") != std::string::npos;
    return text.substr(0, colon) + (repeated ? ": given more than once" : ": its value is missing");
  }
  return text;
}

/// Removes the "all" behind --help; true if it was there.
bool take_all(std::vector<std::string>& arguments) {
  const auto is_help = [](const std::string& word) { return word == "--help" || word == "-h"; };
  const auto help = std::ranges::find_if(arguments, is_help);
  if (help == arguments.end() || help + 1 == arguments.end() || *(help + 1) != "all") return false;
  arguments.erase(help + 1);
  return true;
}

/// Replaces "help COMMAND" by "COMMAND --help", and "help COMMAND all" by "COMMAND --help all".
void take_help(std::vector<std::string>& arguments, const CLI::App& app) {
  if (arguments.empty() || arguments.front() != "help") return;
  const std::vector<std::string_view> names = names_of_commands(app);
  const bool all = arguments.size() > 2 && arguments.back() == "all";
  if (all) arguments.pop_back();
  if (arguments.size() > 2) throw UsageError("help: one command at a time: ligne help COMMAND");
  if (arguments.size() == 2 && !is_option(arguments[1]) && std::ranges::find(names, arguments[1]) == names.end()) {
    throw UsageError("help: there is no command " + shown(arguments[1], '"') + suggestion(arguments[1], names) +
                     "; there are " + list_of(names));
  }
  arguments.erase(arguments.begin());
  if (arguments.empty() || !is_option(arguments.back())) arguments.emplace_back("--help");
  if (all) arguments.emplace_back("all");
}

/// The arguments behind the program's name in reverse order, as CLI11 expects them.
std::vector<std::string> arguments_for(CLI::App& app, int argc, char** argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  take_help(arguments, app);
  const auto formatter = std::make_shared<HelpFormatter>(take_all(arguments));
  app.formatter(formatter);
  for (CLI::App* command : app.get_subcommands(nullptr)) command->formatter(formatter);
  if (!arguments.empty() && arguments.front() == "surface") {
    const CLI::App& surface = *app.get_subcommand("surface");
    protect_formulas(arguments, [&](const std::string& word) {
      const CLI::Option* const option = word.starts_with('-') ? surface.get_option_no_throw(word) : nullptr;
      return option && option->get_items_expected_max() > 0;
    });
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

/// Parses the arguments behind the program's name. Prints help or version and returns false if they request it. Throws
/// UsageError.
bool parse_arguments(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(arguments_for(app, argc, argv));
    return true;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0) throw UsageError(complaint(e, app));
    std::ostringstream text;
    app.exit(e, text, text);
    write_output("-", text.str());
    return false;
  }
}

/// Runs the work and returns its exit status; reports exceptions on standard error.
int report_errors(const std::function<int()>& work) {
  try {
    return work();
  } catch (const UsageError& e) {
    say(e.what());
    return kUsage;
  } catch (const SettingError& e) {
    const MethodParameter* parameter = find_parameter(e.field());
    say((parameter && parameter->is_experiment ? "--set " : "--") + std::string(e.what()));
    return kUsage;
  } catch (const RequestError& e) {
    say((e.field().empty() ? "" : "--") + std::string(e.what()));
    return kUsage;
  } catch (const MemoryError& e) {
    say(e.what());
  } catch (const std::bad_alloc&) {
    say("not enough memory");
  } catch (const std::exception& e) {
    say(e.what());
  } catch (...) {
    say("the work failed for an unknown reason");
  }
  return kFailed;
}

/// The arguments for `ligne-study`, if the command is `study`.
std::optional<std::vector<std::string>> study_arguments(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  take_help(arguments, app);
  if (arguments.empty() || arguments.front() != "study") return std::nullopt;
  arguments.erase(arguments.begin());
  return arguments;
}

int run(int argc, char** argv) {
  CLI::App app("Draws 3D polygon scenes as line drawings with hidden lines removed.", "ligne");
  app.set_version_flag("--version", "ligne " LIGNE_VERSION);
  app.footer(kFooter);
  app.require_subcommand(0, 1);

  Commands commands;
  setup_commands(app, commands, argc > 1 ? argv[1] : "");
  if (const auto arguments = study_arguments(app, argc, argv)) return run_study_program(*arguments);
  if (!parse_arguments(app, argc, argv)) return kDone;

  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const std::string name = chosen.empty() ? "" : chosen.front()->get_name();
  std::vector<std::string_view> names;
  for (const Command& command : all_commands(commands)) {
    names.push_back(command.name);
    if (command.name != name || !command.run) continue;
    if (command.options) command.options->given = given_options(*chosen.front());
    command.run();
    return kDone;
  }
  throw UsageError("there is no command: " + list_of(names) + "; see ligne --help");
}

}  // namespace

int run_command_line(int argc, char** argv) {
  return report_errors([argc, argv] { return run(argc, argv); });
}

int run_command_program(const CommandProgram& program, int argc, char** argv) {
  return report_errors([&program, argc, argv] {
    CLI::App app("", "ligne");
    program.add(app);
    std::string name = program.name;
    std::vector<char*> arguments(argv, argv + argc);
    arguments.insert(arguments.begin() + std::min(argc, 1), name.data());
    if (parse_arguments(app, static_cast<int>(arguments.size()), arguments.data())) program.run();
    return kDone;
  });
}

}  // namespace ligne
