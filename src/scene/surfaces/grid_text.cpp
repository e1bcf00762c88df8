// A line is a row. The first row decides the separator and the number of columns. Lines of three numbers can also be x, y
// and z (grid_points.cpp): they are when blank lines stand between blocks of them, and when they form a grid without.

#include <algorithm>
#include <limits>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

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
  TextGridReader(std::string_view text, const std::string& name, Warnings& warnings, const GridChoice& choice)
      : text_size_(text.size()), lines_(text), name_(name), warnings_(warnings), choice_(choice) {}

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

  /// A first row of nothing but names: in quotes, as R and spreadsheets write them, or those of the columns of a table.
  bool skip_header(std::string_view row) {
    const std::vector<std::string_view> fields = fields_of(row, separator_);
    if (std::any_of(fields.begin(), fields.end(), [](std::string_view f) { return !f.empty() && height_in(f); }))
      return false;
    const auto is_name = [](std::string_view f) { return f.empty() || is_quoted(f); };
    const bool all_quoted = std::all_of(fields.begin(), fields.end(), is_name);
    std::vector<std::string> names;
    names.reserve(fields.size());
    for (const std::string_view field : fields)
      names.emplace_back(is_quoted(field) ? field.substr(1, field.size() - 2) : field);
    named_ = named_columns(names);
    is_table_ = named_.x && named_.y && named_.z;
    if (is_table_) {
      columns_ = fields.size();
      return true;
    }
    // A frame of named columns begins with a column of its rows' names, which has none itself.
    has_index_ = !all_quoted && names.front().empty() && names.size() > 2;
    if (has_index_) columns_ = fields.size();
    if (!all_quoted && !has_index_) return false;
    warnings_.add("header rows left out");
    if (has_index_) warnings_.add("columns of row names left out");
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
    if (is_table_) return read_table_row(row);
    std::size_t column = 0;
    bool ended = false;
    std::string_view rest = row, field;
    if (has_index_) {
      take_field(rest, separator_, ended);
      ++column;
    } else if (row.front() == '"') {
      take_field(rest, separator_, ended);
      warnings_.add("row names left out");
    }
    const bool has_corner = rows_ == 0 && is_corner(row);
    while (!ended) {
      field = take_field(rest, separator_, ended);
      const bool corner = has_corner && column == 0;
      ++column;
      values_.push_back(corner ? kNoHeight : height(field, column));
    }
    corner_empty_ = corner_empty_ || (rows_ == 0 && (has_corner || fields_of(row, separator_).front().empty()));
    all_end_empty_ = all_end_empty_ && field.empty();
    if (rows_ == 0 && !has_index_) {
      columns_ = column;
      // A row of this kind takes as many bytes as the others, more or less.
      values_.reserve(columns_ * (text_size_ / (row.size() + 1) + 1));
    } else if (column != columns_) {
      throw error("row of " + std::to_string(column) + " columns; those above have " + std::to_string(columns_));
    }
    if (columns_ == 3 && !has_index_) points_.lines.push_back(lines_.number());
    ++rows_;
  }

  /// A first row of numbers behind a single name: the positions of the columns of a frame whose index has a name.
  bool is_corner(std::string_view row) const {
    const std::vector<std::string_view> fields = fields_of(row, separator_);
    if (fields.size() < 3 || fields[0].empty() || is_quoted(fields[0]) || height_in(fields[0])) return false;
    return std::all_of(fields.begin() + 1, fields.end(), [](std::string_view f) { return number_in(f).has_value(); });
  }

  /// Of a row of a table the columns that are named.
  void read_table_row(std::string_view row) {
    const std::vector<std::string_view> fields = fields_of(row, separator_);
    if (fields.size() != columns_) {
      throw error("row of " + std::to_string(fields.size()) + " columns; the header names " + std::to_string(columns_));
    }
    for (const std::size_t column : {*named_.x, *named_.y, *named_.z}) {
      values_.push_back(height(fields[column], column + 1));
    }
    points_.lines.push_back(lines_.number());
    ++rows_;
  }

  double height(std::string_view field, std::size_t column) const {
    if (field.empty()) return kNoHeight;
    if (const std::optional<double> value = height_in(field)) return *value;
    if (separator_ == ';') {
      std::string with_point(field);
      std::replace(with_point.begin(), with_point.end(), ',', '.');
      if (const std::optional<double> value = number_in(with_point)) return *value;
    }
    const std::string hint =
        rows_ == 0 ? "; names of columns are passed over when they are in quotes, or tell x, y and z" : "";
    throw error("column " + std::to_string(column) + ": " + shown(field) + " is not a number" + hint);
  }

  std::unique_ptr<HeightSource> finish() {
    if (rows_ == 0) throw InputError(name_, "holds no row of numbers");
    const bool has_places = is_table_ || (columns_ == 3 && !has_index_ && !all_end_empty_);
    leave_out_signs_of_nothing(values_, has_places ? 3 : 1, warnings_);
    if (is_table_) {
      points_.values = std::move(values_);
      points_.block_begins = {0};
      if (find_blocks(points_)) return grid_of_points(std::move(points_), name_);
      return surface_of_rows(points_, choice_, name_, warnings_);
    }
    if (columns_ == 3 && !has_index_ && !all_end_empty_) {
      const bool has_blocks = !points_.block_begins.empty();
      points_.block_begins.insert(points_.block_begins.begin(), 0);
      points_.values = std::move(values_);
      if (has_blocks || find_blocks(points_)) return grid_of_points(std::move(points_), name_);
      if (rows_ > 3 && are_places(points_)) return surface_of_rows(points_, choice_, name_, warnings_);
      values_ = std::move(points_.values);
    }
    if (has_index_) --columns_;
    if (corner_empty_ && !has_index_) {
      if (std::unique_ptr<HeightSource> frame = read_frame()) return frame;
    }
    drop_empty_last_column();
    return held_heights(counted_positions(columns_), counted_positions(rows_), std::move(values_),
                        SampleOrder::first_row_lowest(columns_), name_);
  }

  /// A matrix whose first row and first column are the positions, with nothing in the corner between them.
  std::unique_ptr<HeightSource> read_frame() {
    if (columns_ < 3 || rows_ < 3) return nullptr;
    std::vector<double> x, y, z;
    for (std::size_t i = 1; i < columns_; ++i) x.push_back(values_[i]);
    for (std::size_t j = 1; j < rows_; ++j) y.push_back(values_[j * columns_]);
    const auto ascends = [](const std::vector<double>& at) {
      return std::adjacent_find(at.begin(), at.end(), [](double a, double b) { return !(a < b); }) == at.end();
    };
    const bool downwards = std::is_sorted(y.rbegin(), y.rend());
    if (downwards) std::reverse(y.begin(), y.end());
    if (!ascends(x) || !ascends(y)) return nullptr;
    for (std::size_t j = 1; j < rows_; ++j) {
      const auto row = values_.begin() + static_cast<std::ptrdiff_t>(j * columns_);
      z.insert(z.end(), row + 1, row + static_cast<std::ptrdiff_t>(columns_));
    }
    warnings_.add("rows and columns of numbers taken for positions", 2);
    const SampleOrder order =
        downwards ? SampleOrder::first_row_highest(x.size(), y.size()) : SampleOrder::first_row_lowest(x.size());
    return held_heights(std::move(x), std::move(y), std::move(z), order, name_);
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
  bool all_end_empty_ = true;  ///< no row so far has something behind its last separator
  const GridChoice& choice_;
  NamedColumns named_;
  bool is_table_ = false;       ///< x, y and z are named
  bool has_index_ = false;      ///< the first column holds names of rows
  bool corner_empty_ = false;   ///< the first row begins with no number
  std::vector<double> values_;  ///< row by row
  PointRows points_;            ///< lines and blocks, for rows of three
};

}  // namespace

std::unique_ptr<HeightSource> read_text_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                             const GridChoice& choice) {
  return TextGridReader(as_text(bytes, name), name, warnings, choice).read();
}

}  // namespace ligne
