#pragma once
/// Options that say which lines are drawn and how they are found.

#include <string_view>

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
  double crease_degrees = 30;
  HiddenLines hidden = HiddenLines::none;
  bool cull = false;
};

void add_method_options(CLI::App& app, MethodOptions& options);

/// The method to use; never nullptr. Throws UsageError when there is none.
const Method& method_of(const MethodOptions& options);

}  // namespace ligne
