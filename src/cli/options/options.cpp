#include "cli/options/options.hpp"

#include <CLI/CLI.hpp>

namespace ligne {
namespace {

/// The name used in messages: the last of "-o,--output".
std::string shown_name(const std::string& names) { return names.substr(names.rfind(',') + 1); }

/// Calls work() and turns a std::invalid_argument into a UsageError of the option.
template <class Work>
void check_as(const std::string& option, Work work) {
  try {
    work();
  } catch (const std::invalid_argument& e) {
    throw UsageError(option, e.what());
  }
}

}  // namespace

Option Option::excludes(std::initializer_list<Option> others) const {
  for (const Option& other : others) option_->excludes(other.option_);
  return *this;
}

Option Option::needs(Option other) const {
  option_->needs(other.option_);
  return *this;
}

Option OptionGroup::add_text(const std::string& names, const std::string& kind, std::function<void(const std::string&)> take,
                             const std::string& help, const std::string& standard) {
  const auto checked = [take = std::move(take), name = shown_name(names)](const std::string& text) {
    check_as(name, [&] { take(text); });
  };
  CLI::Option* option = command_.add_option_function<std::string>(names, checked, help);
  option->type_name(kind)->group(name_)->default_str(standard);
  return Option(option);
}

Option OptionGroup::add_flag(const std::string& names, bool& target, const std::string& help) {
  return Option(command_.add_flag(names, target, help)->group(name_));
}

Option OptionGroup::add_flag_with_text(const std::string& names, std::string& target, const std::string& help) {
  return Option(command_.add_flag(names, target, help)->group(name_));
}

Option OptionGroup::add_repeatable(const std::string& names, const std::string& kind,
                                   std::function<void(const std::string&)> take, const std::string& help,
                                   const std::string& standard) {
  const auto take_first = [take = std::move(take)](const std::vector<std::string>& texts) { take(texts[0]); };
  return add_repeatable_tuple(names, kind, 1, take_first, help, standard);
}

Option OptionGroup::add_repeatable_tuple(const std::string& names, const std::string& kind, int count,
                                         std::function<void(const std::vector<std::string>&)> take, const std::string& help,
                                         const std::string& standard) {
  const auto each = [take = std::move(take), count, name = shown_name(names)](const std::vector<std::string>& texts) {
    for (auto from = texts.begin(); texts.end() - from >= count; from += count) {
      check_as(name, [&] { take({from, from + count}); });
    }
  };
  CLI::Option* option = command_.add_option_function<std::vector<std::string>>(names, each, help);
  option->type_size(count)->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  option->type_name(kind)->group(name_)->default_str(standard);
  return Option(option);
}

Option OptionGroup::add_flag_or_value(const std::string& names, const std::string& kind,
                                      std::function<void(const std::string&)> take, const std::string& help) {
  const auto first = [take = std::move(take), name = shown_name(names)](const std::vector<std::string>& texts) {
    check_as(name, [&] { take(texts.empty() ? std::string() : texts[0]); });
  };
  CLI::Option* option = command_.add_option_function<std::vector<std::string>>(names, first, help);
  option->expected(0, 1)->allow_extra_args(false)->type_name(kind)->group(name_);
  return Option(option);
}

Option OptionGroup::add_repeatable_flag_or_value(const std::string& names, const std::string& kind,
                                                 std::function<void(const std::string&)> take, const std::string& help) {
  static constexpr std::string_view kAlone = "true";  // the text that CLI11 gives for a flag without a value
  const auto each = [take = std::move(take), name = shown_name(names)](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) check_as(name, [&] { take(text == kAlone ? std::string() : text); });
  };
  CLI::Option* option = command_.add_option_function<std::vector<std::string>>(names, each, help);
  // Takes a value only behind "=": the next word is an argument, such as a file.
  option->expected(0)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  option->type_name("[=" + kind + "]")->group(name_);
  return Option(option);
}

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& help, const std::string& footer) {
  CLI::App* command = app.add_subcommand(name, help);
  command->footer(footer);
  return command;
}

std::vector<std::string> given_options(const CLI::App& command) {
  std::vector<std::string> given;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || option->get_positional()) continue;
    given.push_back(option->get_lnames().empty() ? "-" + option->get_snames().front() : "--" + option->get_lnames().front());
  }
  return given;
}

void add_arguments(CLI::App& command, const std::string& name, std::vector<std::string>& target, bool required,
                   const std::string& help) {
  command.add_option(name, target, help)->required(required)->type_name("");
}

}  // namespace ligne
