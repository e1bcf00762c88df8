#pragma once
/// Options that a method has of its own, `--resolution N` for example: described by the method's traits, checked by whoever
/// reads them, handed to the study as values.

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

/// A value is a count from `low` to `high`, or one of the `words`; where there are words and `high` is above 0, either will
/// do. Methods may have parameters of the same name; they are one option of the command line, and mean the same.
struct MethodParameter {
  std::string_view name;      ///< "resolution" is the option --resolution
  std::string_view kind;      ///< what stands for the value in a help text, "N"
  std::string_view meaning;   ///< a few words
  std::string_view standard;  ///< what holds when it is not given, as in a help text; may be empty
  std::span<const std::string_view> words{};
  unsigned low = 0, high = 0;
  bool of_compile = false;  ///< a parameter of Method::compile()
};

/// One of the words of a parameter, by its place among them.
struct ParameterWord {
  std::size_t index = 0;
};
using ParameterValue = std::variant<unsigned, ParameterWord>;

/// The values given. A parameter that is not here has the method's own default.
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

  /// The count given; none where there is no value, or a word.
  std::optional<unsigned> count(std::string_view name) const {
    const ParameterValue* value = find(name);
    const unsigned* number = value ? std::get_if<unsigned>(value) : nullptr;
    return number ? std::optional(*number) : std::nullopt;
  }

  /// The word given, as an enumeration whose members stand in the order of the words.
  template <class Enum>
  Enum choice(std::string_view name, Enum standard) const {
    const ParameterValue* value = find(name);
    const ParameterWord* word = value ? std::get_if<ParameterWord>(value) : nullptr;
    assert(word || !value);  // whoever set it has read the description
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
