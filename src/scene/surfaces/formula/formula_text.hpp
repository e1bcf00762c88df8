#pragma once
/// Prepares a typed formula for the parser. Text that the parser reports badly, or reads in its own way, is refused
/// here, where the column is known.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/model/diagnostics.hpp"

namespace ligne {

/// A function of a formula. The functions of `const double*` take one argument or more.
struct FormulaFunction {
  std::string_view name;
  std::variant<double (*)(double), double (*)(double, double), double (*)(double, double, double),
               double (*)(const double*, int)>
      call;
};
std::span<const FormulaFunction> formula_functions();

struct FormulaConstant {
  std::string_view name;
  double value;
};
std::span<const FormulaConstant> formula_constants();

/// The variables of a formula, and its name in error messages.
struct FormulaLanguage {
  std::span<const std::string_view> variables;
  std::string name = "formula";
};

/// Variables of z = f(x, y): Cartesian and polar coordinates.
inline constexpr std::array<std::string_view, 4> kFormulaVariables{"x", "y", "r", "theta"};

/// Largest length of a formula in characters: more than anybody types, and short enough for a parser whose time grows
/// with the square of the length.
inline constexpr std::size_t kLongestFormula = 10'000;

struct FormulaText {
  std::string text;                  ///< without blanks, ** as ^
  std::vector<std::size_t> columns;  ///< columns of the characters of `text`, from 1, and of the end
  std::vector<bool> uses;            ///< per variable of the language: whether it occurs
  FormulaLanguage language;
};

/// Throws InputError for unknown characters and names, adjacent values without an operator, assignments, unmatched
/// parentheses, and formulas that are too long. The names of the language must outlive the result.
FormulaText prepare_formula(std::string_view formula, FormulaLanguage language = {kFormulaVariables});

/// "formula:COLUMN: cause", with the name of the language in place of "formula".
InputError formula_error(const FormulaLanguage& language, std::size_t column, const std::string& cause);

}  // namespace ligne
