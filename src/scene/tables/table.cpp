// Lines are split by the style of the text (cell_style.hpp). Rows before the first number are the head; its last row
// with a cell for every column names the columns.

#include "scene/tables/table.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// Number of rows that are counted to find the usual number of cells.
constexpr std::size_t kRowsCounted = 500;

bool is_in_quotes(std::string_view cell) { return cell.size() >= 2 && cell.front() == '"' && cell.back() == '"'; }

}  // namespace

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& name, Warnings& warnings)
      : text_(text), name_(name), warnings_(warnings) {}

  Table read() {
    table_.style_ = cell_style(text_);
    read_lines();
    if (first_line_counts()) lines_.erase(lines_.begin());
    const std::size_t first = find_body();
    table_.values_.reserve(text_.size() / 8);
    for (std::size_t k = first; k < lines_.size(); ++k) add_row(lines_[k], k == first);
    if (table_.lines_.empty()) throw no_row();
    close_blocks();
    name_columns();
    warn_of_doubts();
    return std::move(table_);
  }

 private:
  struct Line {
    std::string_view text;
    std::size_t number = 0;
    std::size_t blanks_before = 0;  ///< number of blank lines since the previous row
  };

  InputError no_row() const {
    if (lines_.empty()) return {name_, "holds no row of numbers"};
    std::string_view rest = lines_.front().text;
    bool ended = false;
    const std::string_view cell = take_cell(rest, separator(), ended);
    return error_at_line(name_, lines_.front().number,
                         "column 1: " + shown(cell) + " is not a number, and no line holds one");
  }

  char separator() const { return table_.style_.separator; }

  void read_lines() {
    LineReader reader(text_);
    std::size_t blanks = 0;
    for (std::string_view line; reader.next(line);) {
      const std::string_view row = without_comment(line, separator());
      if (row.empty()) {
        // GMT separates segments by lines with ">".
        if (trimmed(line).empty()) ++blanks;
        if (lines_.empty() && is_comment_line(line)) comment_ = trimmed(line).substr(1);
        continue;
      }
      if (row.front() == '>') {
        ++blanks;
        continue;
      }
      lines_.push_back({row, reader.number(), blanks});
      blanks = 0;
    }
  }

  /// Whether the first line is the number of columns and rows below it, in either order. Two columns could be rows of
  /// their own.
  bool first_line_counts() const {
    const std::size_t rows = lines_.empty() ? 0 : lines_.size() - 1;
    const auto cells = [&](const Line& line) { return cells_of(line.text, separator()); };
    if (rows < 2) return false;
    const std::size_t columns = cells(lines_[1]).size();
    const auto first = cells(lines_[0]);
    if (first.size() != 2 || columns == 2) return false;
    const CellValue a = value_of(first[0]), b = value_of(first[1]);
    const auto c = static_cast<double>(columns), r = static_cast<double>(rows);
    return ((a.value == c && b.value == r) || (a.value == r && b.value == c)) &&
           std::all_of(lines_.begin() + 1, lines_.end(), [&](const Line& line) { return cells(line).size() == columns; });
  }

  CellValue value_of(std::string_view cell) const { return cell_value(cell, table_.style_.numbers); }

  std::size_t count(CellKind kind, std::string_view row) const {
    std::size_t found = 0;
    for (bool ended = false; !ended;) found += value_of(take_cell(row, separator(), ended)).kind == kind;
    return found;
  }

  bool has(CellKind kind, std::string_view row) const { return count(kind, row) > 0; }

  bool begins_with_word(std::string_view row) const {
    bool ended = false;
    return value_of(take_cell(row, separator(), ended)).kind == CellKind::word;
  }

  /// The number of cells of rows: that whose lines hold the most numbers.
  std::size_t usual_count() const {
    std::map<std::size_t, std::size_t> numbers;
    for (std::size_t k = 0; k < std::min(lines_.size(), kRowsCounted); ++k) {
      std::string_view row = lines_[k].text;
      std::size_t cells = 0, found = 0;
      for (bool ended = false; !ended; ++cells)
        found += value_of(take_cell(row, separator(), ended)).kind == CellKind::number;
      numbers[cells] += found;
    }
    std::size_t best = 0, most = 0;
    for (const auto& [cells, here] : numbers) {
      if (here >= most) best = cells, most = here;
    }
    return best;
  }

  /// The first line with the usual number of cells that does not begin with a word, if few rows before it do; else 0.
  std::size_t first_plain_row() const {
    std::size_t words = 0;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (cells_of(lines_[k].text, separator()).size() != usual_) continue;
      if (!begins_with_word(lines_[k].text)) return 2 * words <= lines_.size() - k ? k : 0;
      words += has(CellKind::number, lines_[k].text);
    }
    return 0;
  }

  /// Finds the first row of numbers; rows before it become the head.
  std::size_t find_body() {
    usual_ = usual_count();
    const std::size_t first_plain = first_plain_row();
    if (first_plain > 0) first_plain_line_ = lines_[first_plain].number;
    std::size_t k = 0, heads = 0, head_cells = 0;
    for (; k < lines_.size(); ++k) {
      const std::string_view row = lines_[k].text;
      const std::size_t cells = cells_of(row, separator()).size();
      const bool has_number = has(CellKind::number, row),
                 may_be_head = cells == usual_ || (cells + 1 == usual_ && !has_number);
      // Prose, a line "key value", or the number of points.
      const bool is_prose = may_be_head ? k + 1 < first_plain && has_number && count(CellKind::word, row) > 1
                                        : cells == 1 || begins_with_word(row);
      const bool is_empty = !has_number && !has(CellKind::word, row);
      const std::string_view next = k + 1 < lines_.size() ? lines_[k + 1].text : row;
      const bool is_above_names = is_empty && !has(CellKind::number, next) && has(CellKind::word, next);
      if (!is_prose && (has_number || is_empty) && !is_above_names) break;
      const bool is_worse = cells < head_cells || (!head_.empty() && (row.front() == '[' || row.front() == '('));  // units
      if (!is_prose && !is_empty && cells + 1 >= usual_ && !is_worse) head_ = row, head_cells = cells;
      ++heads;
    }
    const bool names = !head_.empty();
    if (heads > (names ? 1 : 0)) warnings_.leave_out("lines above the first row", heads - (names ? 1 : 0));
    if (k < lines_.size() && !begins_with_word(lines_[k].text)) drop_prose_below();
    return k;
  }

  /// Drops the settings that instruments write below the rows.
  void drop_prose_below() {
    const auto is_row = [&](const Line& line) {
      return !begins_with_word(line.text) || cells_of(line.text, separator()).size() == usual_;
    };
    const auto end = std::find_if(lines_.rbegin(), lines_.rend(), is_row).base();
    warnings_.leave_out("lines below the last row", static_cast<std::size_t>(lines_.end() - end));
    lines_.erase(end, lines_.end());
  }

  void add_row(const Line& line, bool is_first) {
    if (!is_first && line.text == head_) {
      warnings_.leave_out("repeated head rows");
      return;
    }
    // Heads of further data sets, and units below a row of positions.
    const bool may_be_head = line.blanks_before > 0 || line.number < first_plain_line_;
    if (!is_first && may_be_head && !has(CellKind::number, line.text) && has(CellKind::word, line.text)) {
      warnings_.leave_out("head rows of data sets");
      pending_blanks_ += line.blanks_before;
      return;
    }
    const std::size_t row = table_.lines_.size(), blanks = line.blanks_before + pending_blanks_;
    pending_blanks_ = 0;
    if (row == 0 || blanks > 0) table_.blocks_.push_back({row, row});
    if (row == 0 || blanks > 1) table_.data_sets_.push_back({row, row});
    std::string_view rest = line.text;
    std::size_t column = 0;
    for (bool ended = false; !ended; ++column) {
      const CellValue cell = value_of(take_cell(rest, separator(), ended));
      if (column == table_.columns_.size()) table_.columns_.emplace_back();
      TableColumn& counts = table_.columns_[column];
      if (cell.kind == CellKind::word && counts.words == 0) counts.first_word_row = row;
      ++(cell.kind == CellKind::number ? counts.numbers : cell.kind == CellKind::word ? counts.words : counts.missing);
      table_.values_.push_back(cell.kind == CellKind::number ? cell.value : std::numeric_limits<double>::quiet_NaN());
    }
    table_.row_begins_.push_back(table_.values_.size());
    table_.lines_.push_back(line.number);
    table_.texts_.push_back(line.text);
  }

  void close_blocks() {
    for (std::vector<RowRange>* ranges : {&table_.blocks_, &table_.data_sets_}) {
      for (std::size_t k = 0; k < ranges->size(); ++k)
        (*ranges)[k].end = k + 1 < ranges->size() ? (*ranges)[k + 1].begin : table_.rows();
    }
  }

  void name_columns() {
    // The number of cells of most rows counts: blanks within a name at the end of a row add cells.
    const std::size_t columns = usual_ > 0 ? usual_ : table_.row(0).size();
    const bool from_comment = head_.empty() && !comment_.empty();
    if (head_.empty() && !from_comment) return;
    std::vector<std::string> names;
    bool all_quoted = true;
    const std::string_view head = from_comment ? comment_ : head_;
    for (const std::string_view cell : cells_of(trimmed_head(head), separator())) {
      names.push_back(cell_text(cell));
      all_quoted = all_quoted && (cell.empty() || is_in_quotes(cell));
    }
    // A separator ends the rows, or the head.
    if (names.size() == columns + 1 && names.back().empty()) names.pop_back();
    table_.has_unnamed_first_ = !from_comment && names.size() + 1 == columns && names.size() > 1;
    if (table_.has_unnamed_first_) names.insert(names.begin(), "");
    if (names.size() != columns || columns > table_.columns_.size()) {
      if (!from_comment) warnings_.leave_out("lines above the first row");
      return;
    }
    table_.names_ = std::move(names);
    table_.has_quoted_names_ = all_quoted;
    table_.names_from_comment_ = from_comment;
  }

  std::string_view trimmed_head(std::string_view head) const { return separator() == '\t' ? head : trimmed(head); }

  void warn_of_doubts() {
    const NumberStyle& numbers = table_.style_.numbers;
    if (table_.style_.doubtful_comma) {
      warnings_.add(numbers.decimal_comma ? "ambiguous number format: 1,234 read as 1.234"
                                          : "ambiguous number format: 1,234 read as 1234");
    }
    if (table_.style_.doubtful_point) warnings_.add("ambiguous number format: 1.234 read as 1234");
  }

  std::string_view text_;
  const std::string& name_;
  Warnings& warnings_;
  Table table_;
  std::vector<Line> lines_;
  std::string_view head_, comment_;  ///< the row that names the columns; the comment above the first row
  std::size_t usual_ = 0, pending_blanks_ = 0, first_plain_line_ = 0;
};

std::vector<std::string> Table::cells(std::size_t row) const {
  std::vector<std::string> cells;
  for (const std::string_view cell : cells_of(texts_[row], style_.separator)) cells.push_back(cell_text(cell));
  return cells;
}

Table read_table(std::string_view text, const std::string& name, Warnings& warnings) {
  return TableReader(text, name, warnings).read();
}

void check_even(const Table& table, RowRange rows, const std::string& name) {
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    const std::size_t columns = table.row(rows.begin).size(), here = table.row(row).size();
    if (here == columns) continue;
    throw error_at_line(name, table.line(row),
                        "row of " + std::to_string(here) + (here == 1 ? " column" : " columns") +
                            (table.names().empty() ? "; those above have " : "; the header names ") +
                            std::to_string(columns));
  }
}

InputError word_error(const Table& table, std::size_t column, const std::string& name) {
  const std::size_t row = table.column(column).first_word_row;
  return error_at_line(name, table.line(row),
                       "column " + std::to_string(column + 1) + ": " + shown(table.cells(row)[column]) + " is not a number");
}

}  // namespace ligne
