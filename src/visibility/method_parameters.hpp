#pragma once
/// Options that a method has of its own, `--resolution N` for example: described by the method's traits, checked by whoever
/// reads them, handed to the study as values.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ligne {

/// A value is a whole number: one from `low` to `high`, or the index of one of the `words` when there are any; where there
/// are words and `high` is above 0, either will do, and the words stand for high + 1, high + 2 and so on. Methods may have
/// parameters of the same name; they are one option of the command line, and mean the same.
struct MethodParameter {
  std::string_view name;      ///< "resolution" is the option --resolution
  std::string_view kind;      ///< what stands for the value in a help text, "N"
  std::string_view meaning;   ///< a few words
  std::string_view standard;  ///< what holds when it is not given, as in a help text; may be empty
  std::span<const std::string_view> words{};
  unsigned low = 0, high = 0;
  bool of_compile = false;  ///< a parameter of Method::compile()
};

/// The values given. A parameter that is not here has the method's own default.
class MethodSettings {
 public:
  void set(std::string_view name, unsigned value) {
    for (auto& [known, v] : values_) {
      if (known == name) {
        v = value;
        return;
      }
    }
    values_.emplace_back(name, value);
  }

  std::optional<unsigned> find(std::string_view name) const {
    for (const auto& [known, value] : values_) {
      if (known == name) return value;
    }
    return std::nullopt;
  }

  /// The value as an enumeration whose members stand in the order of the words.
  template <class Enum>
  Enum choice(std::string_view name, Enum standard) const {
    const auto value = find(name);
    return value ? static_cast<Enum>(*value) : standard;
  }

 private:
  std::vector<std::pair<std::string, unsigned>> values_;
};

}  // namespace ligne
