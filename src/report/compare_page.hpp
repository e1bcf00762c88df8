#pragma once
/// A comparison of methods as a page for a browser.

#include <string>

#include "report/compare.hpp"

namespace ligne {

/// Returns one self-contained HTML file: drawings as inline SVG, differences from the reference in red, tables. `name`
/// is the name of the model. A drawing without differences refers to the reference, which the page holds once.
std::string compare_page(const MethodComparison& comparison, const std::string& name);

}  // namespace ligne
