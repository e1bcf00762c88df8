#pragma once
/// One cell of a table as text: a number, a sign for a missing value, or a word.

#include <cstdint>
#include <string>
#include <string_view>

namespace ligne {

/// How the numbers of a text are written.
struct NumberStyle {
  bool decimal_comma = false;
  /// Between groups of three digits: ',' or '.', '\'' or ' ' (also the no-break spaces of UTF-8); 0 for none.
  char thousands = '\0';
};

enum class CellKind : std::uint8_t { number, missing, word };

struct CellValue {
  CellKind kind = CellKind::word;
  double value = 0;  ///< NaN unless it is a number
};

/// The cell without blanks and without the quotes round it; "" within quotes stands for one.
std::string cell_text(std::string_view cell);

/// Understands quotes, exponents with D, the minus sign of Unicode, and the signs for missing values of is_missing().
CellValue cell_value(std::string_view cell, NumberStyle style);

/// Signs for no value, whatever the case of their letters: nothing, nan, inf, na, n/a, null, none, nil, nodata, missing,
/// undefined, ?, ., a run of '-' or '*', the errors of spreadsheets (#N/A) and of C libraries (1.#QNAN).
bool is_missing(std::string_view cell);

/// "#N/A", "#DIV/0!" and their like at the beginning of a text: no comment begins there.
bool begins_with_sheet_error(std::string_view text);

/// How the commas and points of one cell can be understood.
struct CommaEvidence {
  bool decimal = false;        ///< only as a decimal comma: "0,5", "1.234,5"
  bool thousands = false;      ///< only as separators of thousands: "1,234,567", "1,234.5"
  bool either = false;         ///< "1,234"
  bool point = false;          ///< a number with a decimal point that separates no thousands: "1.5"
  bool grouped_point = false;  ///< "1.234", "1.234.567"
  bool both = false;           ///< points between thousands before a decimal comma: "1.234,5"
};
CommaEvidence comma_evidence(std::string_view cell);

}  // namespace ligne
