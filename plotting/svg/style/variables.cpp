#include "plotting/svg/style/variables.hpp"

#include <algorithm>
#include <utility>

#include "plotting/svg/style/css_text.hpp"
#include "plotting/svg/values.hpp"

namespace ligne::svg {
namespace {

/// Most bytes of a value with its var() resolved.
constexpr std::size_t kLongestValue = std::size_t{1} << 16;
/// Most bytes of the properties of one element: a few names could ask for many long values.
constexpr std::size_t kLongestValues = std::size_t{1} << 20;
/// Deepest nesting of var(), in fallbacks of var() and through properties that refer to properties.
constexpr int kDeepestVariable = 32;

using VariableValues = std::map<std::string, std::string, std::less<>>;

/// Resolves the properties that one element defines, each once.
class VariableResolver {
 public:
  VariableResolver(const VariablesPointer& outer, VariableValues defined) : outer_(outer), defined_(std::move(defined)) {}

  std::optional<std::string> resolve(std::string_view value, int depth) {
    if (depth > kDeepestVariable) return {};
    std::string text;
    for (std::size_t at; (at = value.find("var(")) != std::string_view::npos;) {
      text += value.substr(0, at);
      value.remove_prefix(at + 4);
      std::string_view inside = take_block(value, ')');
      const std::size_t comma = find_outside(inside, ",");
      std::optional<std::string> found = value_of(trimmed(inside.substr(0, comma)), depth);
      if (!found && comma != std::string_view::npos) found = resolve(trimmed(inside.substr(comma + 1)), depth + 1);
      if (!found) return {};
      text += *found;
      if (text.size() > kLongestValue) return {};
    }
    text += value;
    if (text.size() > kLongestValue) return {};
    return text;
  }

  VariableValues all() {
    VariableValues values;
    for (const auto& [name, value] : defined_) {
      std::optional<std::string> found = value_of(name, 0);
      if (found && total_ <= kLongestValues) values.emplace(name, std::move(*found));
    }
    return values;
  }

 private:
  std::optional<std::string> value_of(std::string_view name, int depth) {
    const auto own = defined_.find(name);
    if (own == defined_.end()) {
      for (const Variables* at = outer_.get(); at; at = at->outer.get()) {
        const auto found = at->values.find(name);
        if (found != at->values.end()) return found->second;
      }
      return {};
    }
    const auto [known, is_new] = done_.emplace(name, std::nullopt);
    // A property that is being resolved has no value: it leads back to itself.
    if (!is_new) return known->second;
    std::optional<std::string> value = total_ <= kLongestValues ? resolve(own->second, depth + 1) : std::nullopt;
    if (value) total_ += value->size();
    return known->second = std::move(value);
  }

  const VariablesPointer& outer_;
  VariableValues defined_;
  std::map<std::string, std::optional<std::string>, std::less<>> done_;
  std::size_t total_ = 0;  ///< bytes of the resolved values
};

}  // namespace

VariablesPointer with_variables(VariablesPointer outer, VariableValues defined) {
  auto made = std::make_shared<Variables>();
  made->values = VariableResolver(outer, std::move(defined)).all();
  made->outer = std::move(outer);
  return made;
}

std::optional<std::string> resolved(std::string_view value, const VariablesPointer& variables) {
  return VariableResolver(variables, {}).resolve(value, 0);
}

}  // namespace ligne::svg
