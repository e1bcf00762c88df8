#pragma once
/// Options of a command, in groups of its help text. Their texts are read by functions of ours, so that every mistake gives
/// one line of ours. The library that takes the command line apart (CLI11) is known to options.cpp and main.cpp alone: its
/// headers take seconds to compile.

#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/errors.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ligne {

/// One option of a command.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  /// The default, for the help text.
  Option standard(const std::string& text) const;
  /// It can not be given together with any of the others.
  Option excludes(std::initializer_list<Option> others) const;
  /// It can only be given together with the other one.
  Option needs(Option other) const;

 private:
  CLI::Option* option_;
};

/// A group of options of one command. What an option writes to must outlive the parse.
class OptionGroup {
 public:
  OptionGroup(CLI::App& command, std::string name) : command_(command), name_(std::move(name)) {}

  /// An option "NAMES KIND" whose text becomes the value of `target` through `parser`; a std::invalid_argument of the parser
  /// becomes a UsageError that begins with the option's name.
  template <class Target, class Parser>
  Option add(const std::string& names, const std::string& kind, Target& target, Parser parser, const std::string& help) {
    return add_text(
        names, kind, [&target, parser = std::move(parser)](const std::string& text) { target = parser(text); }, help);
  }
  /// An option whose text goes to `take`, as it is.
  Option add_text(const std::string& names, const std::string& kind, std::function<void(const std::string&)> take,
                  const std::string& help);
  /// An option without a value.
  Option add_flag(const std::string& names, bool& target, const std::string& help);
  /// An option that may be given several times, each with one value.
  Option add_repeatable(const std::string& names, const std::string& kind, std::function<void(const std::string&)> take,
                        const std::string& help);
  /// As above, with `count` values each time.
  Option add_repeatable_tuple(const std::string& names, const std::string& kind, int count,
                              std::function<void(const std::vector<std::string>&)> take, const std::string& help);
  /// An option that may stand alone, for which `take` is given an empty text, or with a value.
  Option add_flag_or_value(const std::string& names, const std::string& kind, std::function<void(const std::string&)> take,
                           const std::string& help);
  /// As above, with a value behind "=" alone, so that a file may stand next; each use of it adds one.
  Option add_repeatable_flag_or_value(const std::string& names, const std::string& kind,
                                      std::function<void(const std::string&)> take, const std::string& help);
  /// A flag that may be given a value behind "=", "--axes=grid"; alone it is "true".
  Option add_flag_with_text(const std::string& names, std::string& target, const std::string& help);

 private:
  CLI::App& command_;
  std::string name_;
};

/// Adds a command; `help` is one line.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& help, const std::string& footer);

/// Names of the options of a command that its line gives, such as "--dpi" and "-x".
std::vector<std::string> given_options(const CLI::App& command);

/// Adds what stands behind the command without an option's name.
void add_argument(CLI::App& command, const std::string& name, std::string& target, const std::string& help);
void add_arguments(CLI::App& command, const std::string& name, std::vector<std::string>& target, bool required,
                   const std::string& help);

}  // namespace ligne
