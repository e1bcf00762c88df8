#include "option_table.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <map>
#include <span>
#include <string_view>

#include "cli/commands.hpp"
#include "linework/stroke.hpp"
#include "picture/requests.hpp"
#include "picture/surface/surface_request.hpp"
#include "plotting/devices/device.hpp"
#include "plotting/paths/optimize.hpp"
#include "studies/command.hpp"
#include "view/view.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

using Words = std::vector<std::string>;

Words words(std::span<const std::string_view> names) { return {names.begin(), names.end()}; }

/// Values of options whose kind does not list them.
const std::map<std::string, Words, std::less<>>& words_by_name() {
  static const auto table = [] {
    std::map<std::string, Words, std::less<>> all{
        {"--view", words(kNamedViews)},
        {"--hidden", words(kHiddenLinesNames)},
        {"--quality", words(kQualityNames)},
        {"--profile", words(kProfileNames)},
        {"--hatch", words(kHatchNames)},
        {"--format", words(kOutputFormatNames)},
        {"--optimize", words(kOptimizeNames)},
        {"--curves", words(kSwitchNames)},
        {"--group", {"none", "object"}},
        {"--progress", {"auto", "always", "never"}},
        {"--page", {"A0", "A1", "A2", "A3", "A4", "A5", "A6", "letter", "legal", "tabloid"}},
        {"--unit", {"mm", "cm", "m", "in"}},
        {"--edges", {"feature", "all", "shadow", "profile", "tangent", "suggestive", "ridge", "valley", "detail"}},
        {"--weld", {"auto", "off"}},
        {"--method", {"auto"}},
        {"--axes", {"back", "grid", "box", "base"}}};
    all["--view"].emplace_back("camera");
    for (std::size_t i = 0; i < kEdgeClassCount; ++i) all["--edges"].emplace_back(kLineClassNames[i]);
    for (const Device& device : devices()) all["--device"].push_back(device.name);
    for (const Method* method : all_methods()) {
      all["--method"].emplace_back(method->traits().name);
      for (const MethodParameter& parameter : method->traits().parameters) {
        if (!parameter.words.empty()) all["--" + std::string(parameter.name)] = words(parameter.words);
      }
    }
    return all;
  }();
  return table;
}

/// "same|apart|none"; what is not in small letters stands for something else.
Words words_of_kind(const std::string& kind) {
  Words found;
  if (kind.find('|') == std::string::npos) return found;
  for (std::size_t begin = 0; begin <= kind.size();) {
    const std::size_t end = std::min(kind.find('|', begin), kind.size());
    const std::string word = kind.substr(begin, end - begin);
    if (!word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::islower(c) != 0; })) {
      found.push_back(word);
    }
    begin = end + 1;
  }
  return found;
}

Words words_of(const CommandEntry& command, const OptionEntry& option) {
  if (option.names.front() == "--fill") {
    return command.name == "plot" ? Words{"refuse", "outline", "hatch"} : words(kFillNames);
  }
  if (Words found = words_of_kind(option.kind); !found.empty()) return found;
  const auto known = words_by_name().find(option.names.front());
  if (known == words_by_name().end()) return {};
  Words found = known->second;
  if (option.names.front() == "--method" && command.name == "surface") found.emplace_back("horizon");
  return found;
}

OptionEntry entry_of(const CLI::Option& option) {
  OptionEntry entry;
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  if (option.get_positional()) entry.names.push_back(option.get_name(true));
  if (option.get_type_size() != 0) entry.kind = option.get_type_name();
  entry.standard = option.get_default_str();
  entry.help = option.get_description();
  entry.group = option.get_group();
  entry.is_file = entry.kind == "FILE";
  entry.may_stand_alone = option.get_expected_min() == 0;
  entry.repeatable = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  return entry;
}

CommandEntry table_of(const CLI::App& app, std::string name) {
  CommandEntry command{std::move(name), app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    OptionEntry entry = entry_of(*option);
    if (option->get_positional()) {
      if (option->get_expected_max() >= CLI::detail::expected_max_vector_size) entry.names.front() += "...";
      command.positionals.push_back(std::move(entry));
      continue;
    }
    entry.words = words_of(command, entry);
    command.options.push_back(std::move(entry));
  }
  return command;
}

}  // namespace

std::vector<CommandEntry> command_table() {
  CLI::App app("Draws 3D polygon scenes as clean lines, hidden parts removed", "ligne");
  app.set_version_flag("--version", "");
  Commands commands;
  setup_commands(app, commands);
  std::vector<CommandEntry> table{table_of(app, "")};
  for (const CLI::App* command : app.get_subcommands({})) table.push_back(table_of(*command, command->get_name()));
  // The study is a program of its own, which knows its options.
  CLI::App study_app("", "ligne");
  StudyCommandOptions study;
  setup_study(study_app, study);
  for (CommandEntry& entry : table) {
    if (entry.name == "study") entry = table_of(*study_app.get_subcommand("study"), "study");
  }
  return table;
}

}  // namespace ligne
