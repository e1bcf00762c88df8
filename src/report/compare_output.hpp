#pragma once
/// A comparison of methods as a table for people, and for programs.

#include <string>
#include <vector>

#include "report/compare.hpp"

namespace ligne {

std::string compare_text(const MethodComparison& comparison);

/// One row for each method: the columns are the same for all.
std::string compare_csv(const MethodComparison& comparison);

/// {"format": "ligne-compare", "version": 1, ...}, docs/compare.md. One schema for all methods: what does not apply is null.
std::string compare_json(const MethodComparison& comparison, const std::vector<std::string>& files);

}  // namespace ligne
