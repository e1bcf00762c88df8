#pragma once
/// Options that say which lines are drawn and how they are found.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing/stroke.hpp"
#include "visibility/method.hpp"

namespace CLI {
class App;
}

namespace ligne {

enum class HiddenLines { none, dashed, solid };
inline constexpr std::string_view kHiddenLinesNames[] = {"none", "dashed", "solid"};

struct MethodOptions {
  const Method* method = nullptr;  ///< nullptr: the default method
  LineClasses edges;               ///< add_method_options() sets the default
  bool edges_given = false;
  double crease_degrees = 30;
  HiddenLines hidden = HiddenLines::none;
  bool cull = false;
  std::vector<std::pair<const MethodParameter*, std::string>> given;  ///< options that only some methods have
};

void add_method_options(CLI::App& app, MethodOptions& options);

/// The method to use; never nullptr. Throws UsageError when there is none.
const Method& method_of(const MethodOptions& options);

/// The values for the method's own parameters. Throws UsageError for one that it does not have, or not with this value.
MethodSettings settings_of(const MethodOptions& options, const Method& method);

}  // namespace ligne
