#pragma once
/// Options of a command, in the groups of its help text. Functions of the program parse their texts, so that every mistake
/// gives a one-line message. In src, only options.cpp and command_line.cpp include CLI11: its headers take seconds to
/// compile.

#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "picture/parse/parse.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ligne {

/// A mistake on the command line: reported in one line on standard error, exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  UsageError(const std::string& option, const std::string& cause) : std::runtime_error(option + ": " + cause) {}
};

/// One option of a command.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  /// Forbids the option together with any of the others.
  Option excludes(std::initializer_list<Option> others) const;
  /// Requires the other option.
  Option needs(Option other) const;

 private:
  CLI::Option* option_;
};

/// A group of options of one command. The targets of options must outlive the parse. `standard` is the default shown in the
/// help text; empty: none.
class OptionGroup {
 public:
  OptionGroup(CLI::App& command, std::string name) : command_(command), name_(std::move(name)) {}

  /// An option "NAMES KIND" that stores the result of `parser` in `target`. A std::invalid_argument of the parser becomes a
  /// UsageError that begins with the option's name.
  template <class Target, class Parser>
  Option add(const std::string& names, const std::string& kind, Target& target, Parser parser, const std::string& help,
             const std::string& standard = {}) {
    const auto take = [&target, parser = std::move(parser)](const std::string& text) { target = parser(text); };
    return add_text(names, kind, take, help, standard);
  }
  /// An option that passes its text to `take`.
  Option add_text(const std::string& names, const std::string& kind, std::function<void(const std::string&)> take,
                  const std::string& help, const std::string& standard = {});
  /// An option without a value.
  Option add_flag(const std::string& names, bool& target, const std::string& help);
  /// A repeatable option with one value each time.
  Option add_repeatable(const std::string& names, const std::string& kind, std::function<void(const std::string&)> take,
                        const std::string& help, const std::string& standard = {});
  /// A repeatable option that appends the result of `parser` to `targets`.
  template <class Item, class Parser>
  Option add_each(const std::string& names, const std::string& kind, std::vector<Item>& targets, Parser parser,
                  const std::string& help, const std::string& standard = {}) {
    const auto take = [&targets, parser = std::move(parser)](const std::string& text) { targets.push_back(parser(text)); };
    return add_repeatable(names, kind, take, help, standard);
  }
  /// A repeatable option with `count` values each time.
  Option add_repeatable_tuple(const std::string& names, const std::string& kind, int count,
                              std::function<void(const std::vector<std::string>&)> take, const std::string& help,
                              const std::string& standard = {});
  /// An option with an optional value; `take` receives an empty text if there is none.
  Option add_flag_or_value(const std::string& names, const std::string& kind, std::function<void(const std::string&)> take,
                           const std::string& help);
  /// A repeatable option with an optional value behind "=", so that a file may follow it.
  Option add_repeatable_flag_or_value(const std::string& names, const std::string& kind,
                                      std::function<void(const std::string&)> take, const std::string& help);
  /// A flag with an optional value behind "=", such as "--axes=grid"; the flag alone gives "true".
  Option add_flag_with_text(const std::string& names, std::string& target, const std::string& help);

 private:
  CLI::App& command_;
  std::string name_;
};

/// A parser that accepts one of the words, which name the values of Enum in order.
template <class Enum, std::size_t N>
auto parse_word(const std::string_view (&words)[N]) {
  return [&words](const std::string& text) { return static_cast<Enum>(parse_choice(text, words)); };
}

/// A parser of whole numbers from `low` to `high`.
inline auto count_between(unsigned low, unsigned high) {
  return [low, high](const std::string& text) { return parse_count(text, low, high); };
}

/// Adds a command. `help` is one line.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& help, const std::string& footer);

/// Names of the options given on the command's line, such as "--dpi" and "-x".
std::vector<std::string> given_options(const CLI::App& command);

/// Adds positional arguments.
void add_arguments(CLI::App& command, const std::string& name, std::vector<std::string>& target, bool required,
                   const std::string& help);

}  // namespace ligne
