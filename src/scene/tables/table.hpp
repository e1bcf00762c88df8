#pragma once
/// Reads a text as a table: rows of cells in named columns, and blocks of rows between blank lines.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/tables/cell_style.hpp"

namespace ligne {

/// Number of cells of each kind in a column.
struct TableColumn {
  std::size_t numbers = 0, missing = 0, words = 0;
  std::size_t first_word_row = 0;

  bool is_text() const { return words > 0 && numbers == 0; }
};

/// A range of rows of a table: first, and one past the last.
struct RowRange {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
};

/// The numbers of a text; words are read on demand. Refers to the text, which must outlive the table.
class Table {
 public:
  std::size_t rows() const { return lines_.size(); }
  /// Largest number of cells in a row.
  std::size_t columns() const { return columns_.size(); }
  /// The numbers of a row; NaN for missing values and words.
  std::span<const double> row(std::size_t row) const {
    return std::span(values_).subspan(row_begins_[row], row_begins_[row + 1] - row_begins_[row]);
  }
  std::size_t line(std::size_t row) const { return lines_[row]; }
  const TableColumn& column(std::size_t column) const { return columns_[column]; }
  /// Names of the columns, without their units; empty if the text has none.
  const std::vector<std::string>& names() const { return names_; }
  bool has_quoted_names() const { return has_quoted_names_; }
  /// Whether the names are in a comment above the first row.
  bool names_from_comment() const { return names_from_comment_; }
  /// Whether rows have one cell more than there are names: the first column then holds the names of rows, as R writes
  /// them.
  bool has_unnamed_first() const { return has_unnamed_first_; }

  /// As in gnuplot, at least one blank line separates blocks, and at least two separate data sets.
  const std::vector<RowRange>& blocks() const { return blocks_; }
  const std::vector<RowRange>& data_sets() const { return data_sets_; }

  /// The cells of a row as text.
  std::vector<std::string> cells(std::size_t row) const;
  const CellStyle& style() const { return style_; }

 private:
  friend class TableReader;
  CellStyle style_;
  std::vector<std::string> names_;
  bool has_quoted_names_ = false, names_from_comment_ = false, has_unnamed_first_ = false;
  std::vector<TableColumn> columns_;
  std::vector<double> values_;
  std::vector<std::size_t> row_begins_{0};
  std::vector<std::size_t> lines_;
  std::vector<std::string_view> texts_;  ///< text of each row
  std::vector<RowRange> blocks_, data_sets_;
};

/// Reads a text of any layout, including words where other rows have numbers. Counts unused rows in `warnings`. Throws
/// InputError if no row has a number.
Table read_table(std::string_view text, const std::string& name, Warnings& warnings);

/// Throws InputError if the rows have different numbers of cells.
void check_even(const Table& table, RowRange rows, const std::string& name);

/// The InputError for a word where a number is required.
InputError word_error(const Table& table, std::size_t column, const std::string& name);

}  // namespace ligne
