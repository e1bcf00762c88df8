#pragma once
/// The separator of cells in a text, and the notation of its numbers.

#include <string_view>
#include <vector>

#include "scene/tables/cell_value.hpp"

namespace ligne {

struct CellStyle {
  char separator = ' ';  ///< ';', ',', tab, '|', or a blank for any run of white space
  NumberStyle numbers;
  /// "1,234" is ambiguous, and no number of the text decides it: `numbers` has the likelier reading.
  bool doubtful_comma = false;
  bool doubtful_point = false;  ///< likewise "1.234" beside decimal commas
};

/// Takes the next cell off a line, and the separator after it; sets `ended` if none follows. Separators within quotes
/// do not count; an unclosed quote is an ordinary character.
std::string_view take_cell(std::string_view& line, char separator, bool& ended);
std::vector<std::string_view> cells_of(std::string_view line, char separator);

/// The line up to its comment: from a # at the beginning, or after a number or an empty cell. Blanks at the ends are
/// removed; tabs that separate cells stay.
std::string_view without_comment(std::string_view line, char separator);

/// Whether the line is a comment from its beginning: # or %.
bool is_comment_line(std::string_view line);

/// Chooses the separator for which most cells of the first lines are numbers and most lines have equally many cells.
CellStyle cell_style(std::string_view text);

}  // namespace ligne
