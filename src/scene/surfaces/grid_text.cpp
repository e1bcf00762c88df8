// A line is a row. The first row decides the separator and the number of columns. Lines of three numbers can also be x, y
// and z (grid_points.cpp): they are when blank lines stand between blocks of them, and when they form a grid without.

#include <algorithm>
#include <limits>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The line up to a '#' that is not within quotes.
std::string_view without_comment(std::string_view line) {
  bool in_quotes = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') in_quotes = !in_quotes;
    if (line[i] == '#' && !in_quotes) return line.substr(0, i);
  }
  return line;
}

/// Takes the next field and the separator behind it; a blank as separator stands for any run of white space. `ended` becomes
/// true when no separator follows. Separators within quotes are none.
std::string_view take_field(std::string_view& line, char separator, bool& ended) {
  const bool by_blanks = separator == ' ';
  if (by_blanks) line = trimmed(line);
  bool in_quotes = false;
  std::size_t end = 0;
  for (; end < line.size(); ++end) {
    if (line[end] == '"') in_quotes = !in_quotes;
    if (!in_quotes && (by_blanks ? is_blank(line[end]) : line[end] == separator)) break;
  }
  const std::string_view field = trimmed(line.substr(0, end));
  ended = end == line.size();
  line.remove_prefix(ended ? end : end + 1);
  return field;
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (bool ended = false; !ended;) fields.push_back(take_field(line, separator, ended));
  return fields;
}

bool is_quoted(std::string_view field) { return field.size() >= 2 && field.front() == '"' && field.back() == '"'; }

/// What separates the columns of a row, by precedence: a comma can be a decimal comma where semicolons separate, and tabs
/// can be among the blanks of a table that is set by hand.
char separator_of(std::string_view row) {
  const std::vector<std::string_view> by_semicolons = fields_of(row, ';');
  if (by_semicolons.size() > 1) return ';';
  if (fields_of(row, ',').size() > 1) return ',';
  const std::vector<std::string_view> by_tabs = fields_of(row, '\t');
  const auto is_one_word = [](std::string_view field) {
    return is_quoted(field) || field.find(' ') == std::string_view::npos;
  };
  return by_tabs.size() > 1 && std::all_of(by_tabs.begin(), by_tabs.end(), is_one_word) ? '\t' : ' ';
}

class TextGridReader {
 public:
  TextGridReader(std::string_view text, const std::string& name, Warnings& warnings)
      : text_size_(text.size()), lines_(text), name_(name), warnings_(warnings) {}

  std::unique_ptr<HeightSource> read() {
    bool after_blank = false;
    for (std::string_view line; lines_.next(line);) {
      const std::string_view row = trimmed_row(line);
      if (row.empty()) {
        after_blank = after_blank || trimmed(line).empty();  // a comment separates nothing
        continue;
      }
      if (rows_ == 0 && separator_ == '\0') {
        separator_ = separator_of(row);
        if (skip_header(row)) continue;
      }
      if (after_blank && rows_ > 0) begin_block();
      after_blank = false;
      read_row(row);
    }
    return finish();
  }

 private:
  InputError error(const std::string& cause) const { return error_at_line(name_, lines_.number(), cause); }

  /// Without comment and blanks around; tabs that separate columns stay.
  std::string_view trimmed_row(std::string_view line) const {
    std::string_view row = without_comment(line);
    if (trimmed(row).empty()) return {};
    if (row.find('\t') == std::string_view::npos || separator_ == ' ') return trimmed(row);
    while (row.back() == ' ') row.remove_suffix(1);
    while (row.front() == ' ') row.remove_prefix(1);
    return row;
  }

  /// A first row of nothing but quoted names, as R and spreadsheets write it.
  bool skip_header(std::string_view row) {
    const std::vector<std::string_view> fields = fields_of(row, separator_);
    if (!std::all_of(fields.begin(), fields.end(), [](std::string_view f) { return f.empty() || is_quoted(f); }))
      return false;
    warnings_.add("header rows left out");
    return true;
  }

  void begin_block() {
    if (columns_ != 3) {
      throw error("blank lines before this row of a matrix of " + std::to_string(columns_) +
                  " columns; blocks of x y z have three");
    }
    points_.block_begins.push_back(rows_);
  }

  void read_row(std::string_view row) {
    std::size_t column = 0;
    bool ended = false;
    std::string_view rest = row, field;
    if (row.front() == '"') {
      take_field(rest, separator_, ended);
      warnings_.add("row names left out");
    }
    while (!ended) {
      field = take_field(rest, separator_, ended);
      values_.push_back(height(field, ++column));
    }
    all_end_empty_ = all_end_empty_ && field.empty();
    if (rows_ == 0) {
      columns_ = column;
      // A row of this kind takes as many bytes as the others, more or less.
      values_.reserve(columns_ * (text_size_ / (row.size() + 1) + 1));
    } else if (column != columns_) {
      throw error("row of " + std::to_string(column) + " columns; those above have " + std::to_string(columns_));
    }
    if (columns_ == 3) points_.lines.push_back(lines_.number());
    ++rows_;
  }

  double height(std::string_view field, std::size_t column) const {
    if (field.empty()) return kNaN;
    if (const std::optional<double> value = height_in(field)) return *value;
    if (separator_ == ';') {
      std::string with_point(field);
      std::replace(with_point.begin(), with_point.end(), ',', '.');
      if (const std::optional<double> value = number_in(with_point)) return *value;
    }
    const std::string hint = rows_ == 0 ? "; names of columns are passed over when they are in quotes" : "";
    throw error("column " + std::to_string(column) + ": " + shown(field) + " is not a number" + hint);
  }

  std::unique_ptr<HeightSource> finish() {
    if (rows_ == 0) throw InputError(name_, "holds no row of numbers");
    if (columns_ == 3) {
      const bool has_blocks = !points_.block_begins.empty();
      points_.block_begins.insert(points_.block_begins.begin(), 0);
      points_.values = std::move(values_);
      if (has_blocks || find_blocks(points_)) return grid_of_points(std::move(points_), name_);
      values_ = std::move(points_.values);
    }
    drop_empty_last_column();
    return held_heights(counted_positions(columns_), counted_positions(rows_), std::move(values_),
                        SampleOrder::first_row_lowest(columns_), name_);
  }

  /// A separator at the end of every row makes a last column of empty fields.
  void drop_empty_last_column() {
    if (!all_end_empty_ || columns_ < 2) return;
    for (std::size_t j = 0; j < rows_; ++j) {
      const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(j * columns_);
      std::copy_n(begin, columns_ - 1, values_.begin() + static_cast<std::ptrdiff_t>(j * (columns_ - 1)));
    }
    --columns_;
    values_.resize(rows_ * columns_);
  }

  std::size_t text_size_;
  LineReader lines_;
  const std::string& name_;
  Warnings& warnings_;
  char separator_ = '\0';  ///< zero before the first row
  std::size_t columns_ = 0, rows_ = 0;
  bool all_end_empty_ = true;   ///< no row so far has something behind its last separator
  std::vector<double> values_;  ///< row by row
  PointRows points_;            ///< lines and blocks, for rows of three
};

}  // namespace

std::unique_ptr<HeightSource> read_text_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings) {
  return TextGridReader(as_text(bytes, name), name, warnings).read();
}

}  // namespace ligne
