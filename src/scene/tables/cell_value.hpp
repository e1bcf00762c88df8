#pragma once
/// One cell of a table as text: a number, a sign for a missing value, or a word.

#include <cstdint>
#include <string>
#include <string_view>

namespace ligne {

/// Notation of the numbers of a text.
struct NumberStyle {
  bool decimal_comma = false;
  /// Separator of groups of three digits: ',', '.', '\'' or ' ' (also the no-break spaces of UTF-8); 0 for none.
  char thousands = '\0';
};

enum class CellKind : std::uint8_t { number, missing, word };

struct CellValue {
  CellKind kind = CellKind::word;
  double value = 0;  ///< NaN unless it is a number
};

/// The cell without blanks and without the quotes around it; "" within quotes becomes a single quote.
std::string cell_text(std::string_view cell);

/// Parses a cell, including quotes, exponents with D, Unicode's minus sign, and the missing values of is_missing().
CellValue cell_value(std::string_view cell, NumberStyle style);

/// Whether a cell means a missing value, in any case of letters: nothing, nan, inf, na, n/a, null, none, nil, nodata,
/// missing, undefined, ?, ., a run of '-' or '*', the errors of spreadsheets (#N/A) and of C libraries (1.#QNAN).
bool is_missing(std::string_view cell);

/// Whether a text begins with "#N/A", "#DIV/0!" or the like, which begin no comment.
bool begins_with_sheet_error(std::string_view text);

/// Possible readings of the commas and points of one cell.
struct CommaEvidence {
  bool decimal = false;        ///< only a decimal comma fits: "0,5", "1.234,5"
  bool thousands = false;      ///< only separators of thousands fit: "1,234,567", "1,234.5"
  bool either = false;         ///< ambiguous: "1,234"
  bool point = false;          ///< a decimal point that can not separate thousands: "1.5"
  bool grouped_point = false;  ///< "1.234", "1.234.567"
  bool both = false;           ///< points between thousands before a decimal comma: "1.234,5"
};
CommaEvidence comma_evidence(std::string_view cell);

}  // namespace ligne
