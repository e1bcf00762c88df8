#pragma once
/// The separator of the cells of a text, and how its numbers are written.

#include <string_view>
#include <vector>

#include "scene/tables/cell_value.hpp"

namespace ligne {

struct CellStyle {
  char separator = ' ';  ///< ';', ',', tab, '|', or a blank for any run of white space
  NumberStyle numbers;
  /// "1,234" can be read in two ways, and no number of the text says in which: `numbers` has the likelier.
  bool doubtful_comma = false;
  bool doubtful_point = false;  ///< the same of "1.234" beside decimal commas
};

/// Takes the next cell off a line, and the separator behind it; `ended` becomes true where none follows. Separators within
/// quotes are none; a quote that is not closed is a character like others.
std::string_view take_cell(std::string_view& line, char separator, bool& ended);
std::vector<std::string_view> cells_of(std::string_view line, char separator);

/// The line up to its comment: from a # at its beginning, or behind a number or an empty cell. Blanks at the ends are left
/// out; tabs that separate cells stay.
std::string_view without_comment(std::string_view line, char separator);

/// A comment from its beginning: # or %.
bool is_comment_line(std::string_view line);

/// Decides by the first lines, for which separator most cells are numbers, and most lines have as many cells.
CellStyle cell_style(std::string_view text);

}  // namespace ligne
