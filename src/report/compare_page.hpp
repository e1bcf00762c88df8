#pragma once
/// A comparison of methods as a page for a browser.

#include <string>

#include "report/compare.hpp"

namespace ligne {

/// One HTML file that needs nothing else: drawings as inline SVG, what differs from the reference in red, tables. `name`: of
/// the model. A drawing that differs nowhere is that of the reference, which the page holds once.
std::string compare_page(const MethodComparison& comparison, const std::string& name);

}  // namespace ligne
