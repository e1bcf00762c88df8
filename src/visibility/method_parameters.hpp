#pragma once
/// Parameters that only some methods have, such as `--lines N` or `--set resolution=N`. The traits of a method describe
/// them, the command line checks their values, and VisibilityOptions::settings passes these to the method.

#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ligne {

/// Description of a parameter. A value is a count from `low` to `high`, or one of the `words`. If there are words and
/// `high` is above 0, both are accepted. A word NAME=X is written as NAME, or as NAME= with a number. Parameters of several
/// methods with the same name mean the same, and are one option of the command line.
struct MethodParameter {
  std::string_view name;      ///< "lines" is the option --lines
  std::string_view kind;      ///< placeholder for the value in a help text, such as "N"
  std::string_view meaning;   ///< description in a few words, for the help text
  std::string_view standard;  ///< default as shown in a help text; may be empty
  std::span<const std::string_view> words{};
  unsigned low = 0, high = 0;
  bool of_compile = false;     ///< whether Method::compile() reads it
  bool is_imprecise = false;   ///< its other values draw lines less exactly, as their source does
  bool is_experiment = false;  ///< serves experiments: `--set NAME=VALUE`, no option of the command line by itself
};

/// The parameter as one that serves experiments.
constexpr MethodParameter experiment(MethodParameter parameter) {
  parameter.is_experiment = true;
  return parameter;
}

/// A parameter for experiments whose other values draw lines less exactly.
constexpr MethodParameter imprecise(MethodParameter parameter) {
  parameter.is_imprecise = true;
  return experiment(parameter);
}

/// One of the words of a parameter, by its index in MethodParameter::words.
struct ParameterWord {
  std::size_t index = 0;
  std::optional<double> number{};  ///< behind the word
};
using ParameterValue = std::variant<unsigned, ParameterWord>;

/// The given values of parameters. A parameter without a value has the default of the method.
class MethodSettings {
 public:
  void set(std::string_view name, ParameterValue value) {
    for (auto& [known, v] : values_) {
      if (known == name) {
        v = value;
        return;
      }
    }
    values_.emplace_back(name, value);
  }

  bool has(std::string_view name) const { return find(name) != nullptr; }

  /// The value as a count; nothing if there is no value or if it is a word.
  std::optional<unsigned> count(std::string_view name) const {
    const ParameterValue* value = find(name);
    const unsigned* number = value ? std::get_if<unsigned>(value) : nullptr;
    return number ? std::optional(*number) : std::nullopt;
  }

  /// The number behind a word; nothing if there is none.
  std::optional<double> number(std::string_view name) const {
    const ParameterValue* value = find(name);
    const ParameterWord* word = value ? std::get_if<ParameterWord>(value) : nullptr;
    return word ? word->number : std::nullopt;
  }

  /// The value as a word, converted to an enumeration whose members are in the order of the words; `standard` if there
  /// is not a value.
  template <class Enum>
  Enum choice(std::string_view name, Enum standard) const {
    const ParameterValue* value = find(name);
    const ParameterWord* word = value ? std::get_if<ParameterWord>(value) : nullptr;
    assert(word || !value);  // the command line has checked it against the description
    return word ? static_cast<Enum>(word->index) : standard;
  }

 private:
  const ParameterValue* find(std::string_view name) const {
    for (const auto& [known, value] : values_) {
      if (known == name) return &value;
    }
    return nullptr;
  }

  std::vector<std::pair<std::string, ParameterValue>> values_;
};

}  // namespace ligne
