#pragma once
/// Formats a comparison of methods as a table for people, and for programs.

#include <string>
#include <vector>

#include "report/compare.hpp"

namespace ligne {

std::string compare_text(const MethodComparison& comparison);

/// One row for each method, all with the same columns.
std::string compare_csv(const MethodComparison& comparison);

/// {"format": "ligne-compare", "version": 1, ...}, docs/compare.md. All methods have the same members; those that do
/// not apply are null.
std::string compare_json(const MethodComparison& comparison, const std::vector<std::string>& files);

/// A comparison of methods as a page for a browser.

/// Returns one self-contained HTML file: drawings as inline SVG, differences from the reference in red, tables. `name`
/// is the name of the model. A drawing without differences refers to the reference, which the page holds once.
std::string compare_page(const MethodComparison& comparison, const std::string& name);

}  // namespace ligne
