#include "scene/surfaces/point_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "files/message_text.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grid_formats.hpp"
#include "scene/tables/column_names.hpp"
#include "scene/tables/table.hpp"

namespace ligne {
namespace {

/// A page has no room for the points of a larger file.
constexpr std::uintmax_t kMostBytes = 1u << 26;

/// The rows of a table as points.
class PointColumnsReader {
 public:
  PointColumnsReader(const Table& table, const std::string& name, Warnings& warnings)
      : table_(table), name_(name), warnings_(warnings) {
    const NamedColumns named = named_columns(table.names());
    by_names_ = named.x && named.y;
    if (by_names_)
      take_names(named);
    else
      take_order();
  }

  /// Nothing for a row without a position, which is counted. Throws InputError for a word in place of a position.
  std::optional<LabelledPoint> point(std::size_t row) {
    const std::span<const double> values = table_.row(row);
    LabelledPoint point{{number(values, x_), number(values, y_), kNoHeight}, {}};
    if (!std::isfinite(point.at.x) || !std::isfinite(point.at.y)) {
      check_position(row);
      warnings_.leave_out("rows without x or y");
      return {};
    }
    const std::vector<std::string> cells = table_.cells(row);
    if (by_names_) {
      if (z_) point.at.z = number(values, *z_);
      if (label_ && *label_ < cells.size()) point.label = label_at(cells);
      // Rows without z may be a cell shorter.
      const bool is_short = z_ && std::isnan(point.at.z) && *z_ < cells.size() && point.label.empty();
      if (is_short && cell_value(cells[*z_], table_.style().numbers).kind == CellKind::word) point.label = cells[*z_];
    } else {
      take_rest(values, cells, point);
    }
    if (is_missing(point.label)) point.label.clear();
    return point;
  }

 private:
  static double number(std::span<const double> values, std::size_t column) {
    return column < values.size() ? values[column] : kNoHeight;
  }

  /// Blanks that separate cells also stand within a label at the end of the row.
  std::string label_at(const std::vector<std::string>& cells) const {
    std::string label = cells[*label_];
    const bool is_last = *label_ + 1 == table_.names().size();
    for (std::size_t k = *label_ + 1; is_last && table_.style().separator == ' ' && k < cells.size(); ++k) {
      label += " " + cells[k];
    }
    return label;
  }

  void take_names(const NamedColumns& named) {
    x_ = *named.x;
    y_ = *named.y;
    z_ = named.z;
    label_ = named.label;
    const auto is_used = [&](std::size_t k) { return k == x_ || k == y_ || k == z_ || k == label_; };
    for (std::size_t k = 0; k < table_.columns() && !label_; ++k) {
      if (!is_used(k) && table_.column(k).is_text()) label_ = k;
    }
    constexpr std::size_t kMostNames = 8;
    std::string others;
    std::size_t count = 0;
    for (std::size_t k = 0; k < table_.columns(); ++k) {
      if (is_used(k)) continue;
      if (count++ < kMostNames) others += (others.empty() ? "" : ", ") + shown_column(table_, k);
    }
    if (count > 0) warnings_.leave_out((count == 1 ? "column (" : "columns (") + others + ")", count);
  }

  /// The first two columns of numbers; a column of words before them is the label.
  void take_order() {
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < table_.columns() && numbers.size() < 2; ++k) {
      const TableColumn& column = table_.column(k);
      if (column.numbers > 0 && column.numbers >= column.words) numbers.push_back(k);
    }
    if (numbers.size() < 2) throw error_at_line(name_, table_.line(0), "does not begin with two numbers, x and y");
    x_ = numbers[0];
    y_ = numbers[1];
    if (x_ > 0 && table_.column(x_ - 1).is_text()) label_ = x_ - 1;
    const bool is_head = !table_.names().empty() && !table_.names_from_comment();
    if (is_head)
      warnings_.add("columns taken for x and y: " + shown_column(table_, x_) + ", " + shown_column(table_, y_), 2);
  }

  void check_position(std::size_t row) const {
    const std::vector<std::string> cells = table_.cells(row);
    for (const std::size_t column : {x_, y_}) {
      const bool is_word = column < cells.size() && cell_value(cells[column], table_.style().numbers).kind == CellKind::word;
      if (is_word || (column >= cells.size() && !by_names_))
        throw error_at_line(name_, table_.line(row), "does not begin with two numbers, x and y");
    }
  }

  /// Behind y: perhaps z, and the label.
  void take_rest(std::span<const double> values, const std::vector<std::string>& cells, LabelledPoint& point) const {
    std::size_t next = y_ + 1;
    if (std::isfinite(number(values, next))) point.at.z = values[next];
    if (next < cells.size() && (std::isfinite(point.at.z) || is_missing(cells[next]))) ++next;
    const char* between = table_.style().separator == ' ' ? " " : ", ";
    for (; next < cells.size(); ++next) {
      if (cells[next].empty()) continue;
      point.label += (point.label.empty() ? "" : between) + cells[next];
    }
    if (point.label.empty() && label_) point.label = cells[*label_];
  }

  const Table& table_;
  const std::string& name_;
  Warnings& warnings_;
  bool by_names_ = false;
  std::size_t x_ = 0, y_ = 0;
  std::optional<std::size_t> z_, label_;
};

}  // namespace

std::vector<LabelledPoint> read_points(const std::string& file, InputFiles& opened, Warnings& warnings) {
  const std::string name = printable(file);
  const std::vector<std::byte> bytes = read_input(file, name, opened, kMostBytes);
  const Table table = read_table(as_text(bytes, name), name, warnings);
  PointColumnsReader reader(table, name, warnings);
  std::vector<LabelledPoint> points;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (auto point = reader.point(row)) points.push_back(std::move(*point));
  }
  if (points.empty()) throw InputError(name, "has no points: rows of x, y, and, if not on the surface, z");
  return points;
}

std::vector<std::vector<Point3>> read_lines(const std::string& file, InputFiles& opened, Warnings& warnings) {
  const std::string name = printable(file);
  const std::vector<std::byte> bytes = read_input(file, name, opened, kMostBytes);
  const Table table = read_table(as_text(bytes, name), name, warnings);
  PointColumnsReader reader(table, name, warnings);
  std::vector<std::vector<Point3>> lines;
  std::size_t labels = 0;
  for (const RowRange& block : table.blocks()) {
    lines.emplace_back();
    for (std::size_t row = block.begin; row < block.end; ++row) {
      const auto point = reader.point(row);
      if (!point && !lines.back().empty()) lines.emplace_back();
      if (!point) continue;
      labels += !point->label.empty();
      lines.back().push_back(point->at);
    }
  }
  warnings.leave_out("labels", labels);
  std::erase_if(lines, [](const auto& line) { return line.size() < 2; });
  if (lines.empty()) throw InputError(name, "has no line: two rows or more of x, y, and, if not on the surface, z");
  return lines;
}

}  // namespace ligne
