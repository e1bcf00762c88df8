#include "scene/tables/cell_value.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
/// Length of a cell above which it is not a number: longer cells do not occur, and the bound keeps the work per cell
/// small.
constexpr std::size_t kLongestNumber = 400;
constexpr std::string_view kMinusSign = "\u2212";
constexpr std::array<std::string_view, 3> kSpaces{"\u00A0", "\u2009", "\u202F"};

constexpr std::array<std::string_view, 12> kMissingValueWords{"nan",  "na", "n/a",    "null",    "none",      "nil",
                                                              "<na>", "?",  "nodata", "missing", "undefined", "."};
constexpr std::array<std::string_view, 8> kSheetErrors{"#n/a",    "#na",   "#null!", "#div/0!",
                                                       "#value!", "#ref!", "#name?", "#num!"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_sign(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text;
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

/// Whether digits are grouped by three after a first group of one to three: "1,234,567". The first group must not be 0.
bool is_grouped(std::string_view digits, char separator) {
  std::size_t group = 0, groups = 0;
  if (digits.empty() || digits.front() == '0') return false;
  for (const char c : digits) {
    if (is_digit(c)) {
      if (++group > 3) return false;
    } else if (c == separator && group > 0 && (groups == 0 || group == 3)) {
      ++groups;
      group = 0;
    } else {
      return false;
    }
  }
  return groups > 0 && group == 3;
}

/// Removes the separators of thousands from a number; false if they are in wrong places.
bool drop_thousands(std::string& text, char separator, char decimal) {
  std::string_view digits = without_sign(text);
  digits = digits.substr(0, digits.find(decimal));
  if (digits.find(separator) == std::string_view::npos) return text.find(separator) == std::string::npos;
  if (!is_grouped(digits, separator)) return false;
  std::erase(text, separator);
  return true;
}

std::optional<double> written_number(std::string_view cell, NumberStyle style) {
  std::string text(cell);
  replace_all(text, kMinusSign, "-");
  const char decimal = style.decimal_comma ? ',' : '.';
  if (style.thousands == ' ') {
    for (const std::string_view space : kSpaces) replace_all(text, space, " ");
  }
  if (style.thousands != '\0' && !drop_thousands(text, style.thousands, decimal)) {
    // "1.5" among numbers with decimal commas and points between thousands is a mistake, neither 1.5 nor 15.
    return {};
  }
  if (style.decimal_comma) {
    if (text.find(',') != text.rfind(',')) return {};
    if (text.find(',') != std::string::npos && text.find('.') != std::string::npos) return {};
    std::replace(text.begin(), text.end(), ',', '.');
  }
  const std::size_t exponent = text.find_first_of("dD");
  if (exponent != std::string::npos && exponent > 0 && (is_digit(text[exponent - 1]) || text[exponent - 1] == '.'))
    text[exponent] = 'e';
  return number_in(text);
}

}  // namespace

std::string cell_text(std::string_view cell) {
  cell = trimmed(cell);
  for (const char quote : {'"', '\''}) {
    if (cell.size() < 2 || cell.front() != quote || cell.back() != quote) continue;
    std::string text(cell.substr(1, cell.size() - 2));
    replace_all(text, std::string(2, quote), std::string(1, quote));
    return text;
  }
  return std::string(cell);
}

bool begins_with_sheet_error(std::string_view text) {
  return std::ranges::any_of(kSheetErrors, [&](std::string_view error) { return starts_with_ignoring_case(text, error); });
}

bool is_missing(std::string_view cell) {
  if (cell.empty()) return true;
  const auto is_run = [&](char c) { return std::ranges::all_of(cell, [c](char at) { return at == c; }); };
  if (is_run('-') || is_run('*')) return true;
  const auto is = [&](std::string_view sign) { return equal_ignoring_case(cell, sign); };
  if (std::ranges::any_of(kMissingValueWords, is)) return true;
  if (std::ranges::any_of(kSheetErrors, is)) return true;
  const std::string_view bare = without_sign(cell);
  for (const std::string_view sign : {"nan", "inf", "infinity", "1.#qnan", "1.#ind", "1.#inf", "1.#snan"}) {
    if (equal_ignoring_case(bare, sign)) return true;
  }
  return false;
}

CellValue cell_value(std::string_view cell, NumberStyle style) {
  cell = trimmed(cell);
  const bool plain = style.thousands == '\0';
  if (plain) {
    if (const std::optional<double> value = number_in(cell)) return {CellKind::number, *value};
  }
  std::string text;
  if (cell.size() >= 2 && (cell.front() == '"' || cell.front() == '\'')) {
    text = cell_text(cell);
    cell = trimmed(text);
    if (plain) {
      if (const std::optional<double> value = number_in(cell)) return {CellKind::number, *value};
    }
  }
  if (is_missing(cell)) return {CellKind::missing, kNoValue};
  if (cell.size() > kLongestNumber) return {CellKind::word, kNoValue};
  if (const std::optional<double> value = written_number(cell, style)) return {CellKind::number, *value};
  return {CellKind::word, kNoValue};
}

CommaEvidence comma_evidence(std::string_view cell) {
  CommaEvidence found;
  std::string_view digits = without_sign(cell);
  const std::size_t exponent = digits.find_first_of("eEdD");
  const std::string_view mantissa = digits.substr(0, exponent);
  const auto commas = std::ranges::count(mantissa, ',');
  const auto points = std::ranges::count(mantissa, '.');
  if (mantissa.empty() || (commas == 0 && points == 0)) return found;
  if (mantissa.find_first_not_of("0123456789,.") != std::string_view::npos) return found;
  if (mantissa.find_first_of("0123456789") == std::string_view::npos) return found;
  if (commas == 0) {
    found.grouped_point = exponent == std::string_view::npos && is_grouped(mantissa, '.');
    found.point = points == 1 && !found.grouped_point;
    return found;
  }
  const std::size_t last_comma = mantissa.rfind(','), last_point = mantissa.rfind('.');
  if (points > 0) {
    const bool point_last = last_point > last_comma;
    const char separator = point_last ? ',' : '.';
    const std::string_view whole = mantissa.substr(0, point_last ? last_point : last_comma);
    if (!is_grouped(whole, separator) || (point_last ? points : commas) > 1) return found;
    (point_last ? found.thousands : found.decimal) = true;
    found.both = !point_last;
    return found;
  }
  const bool grouped = exponent == std::string_view::npos && is_grouped(mantissa, ',');
  found.thousands = grouped && commas > 1;
  found.either = grouped && commas == 1;
  found.decimal = !grouped && commas == 1;
  return found;
}

}  // namespace ligne
