#pragma once
/// A formula as typed, made ready for the parser: what the parser reports badly or reads in its own way is refused here, where the
/// column is known.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/diagnostics.hpp"

namespace ligne {

/// A function of a formula; those of `const double*` take one argument or more.
struct FormulaFunction {
  std::string_view name;
  std::variant<double (*)(double), double (*)(double, double), double (*)(double, double, double), double (*)(const double*, int)>
      call;
};
std::span<const FormulaFunction> formula_functions();

struct FormulaConstant {
  std::string_view name;
  double value;
};
std::span<const FormulaConstant> formula_constants();

/// In the order of FormulaText::uses: x, y, r, theta.
inline constexpr std::array<std::string_view, 4> kFormulaVariables{"x", "y", "r", "theta"};

/// More than anybody types, and little enough for a parser whose time grows with the square of the length.
inline constexpr std::size_t kLongestFormula = 10'000;

struct FormulaText {
  std::string text;                  ///< without blanks, ** as ^
  std::vector<std::size_t> columns;  ///< of the characters of `text`, from 1, and of the end
  std::array<bool, 4> uses{};        ///< which variables occur
};

/// Throws InputError for unknown characters and names, numbers and names side by side, assignments, parentheses without a
/// partner, and whatever is too long.
FormulaText prepare_formula(std::string_view formula);

/// "formula:COLUMN: cause".
InputError formula_error(std::size_t column, const std::string& cause);

}  // namespace ligne
