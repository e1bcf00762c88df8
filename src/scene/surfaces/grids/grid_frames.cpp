// Makes heights of matrices, and of matrices whose rows and columns have positions.

#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"
#include "scene/tables/column_names.hpp"

namespace ligne {
namespace {

/// The numbers of the first column, or the numbers of its months.
std::vector<double> first_column(const Table& table, RowRange rows) {
  std::vector<double> at;
  for (std::size_t row = rows.begin; row < rows.end; ++row) at.push_back(table.row(row)[0]);
  if (!table.column(0).is_text()) return at;
  for (std::size_t row = rows.begin; row < rows.end; ++row)
    at[row - rows.begin] = month_number(table.cells(row)[0]).value_or(kNoHeight);
  return at;
}

/// The heights after the first column.
std::vector<double> heights_behind(const Table& table, RowRange rows, Warnings& warnings) {
  std::vector<double> z;
  z.reserve(rows.size() * (table.row(rows.begin).size() - 1));
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    const std::span<const double> values = table.row(row).subspan(1);
    z.insert(z.end(), values.begin(), values.end());
  }
  drop_missing_values(z, 1, warnings);
  return z;
}

}  // namespace

int direction_of(const std::vector<double>& at) {
  if (at.size() < 2 || at[0] == at[1]) return 0;
  const bool up = at[0] < at[1];
  for (std::size_t i = 1; i < at.size(); ++i) {
    if (up ? !(at[i - 1] < at[i]) : !(at[i - 1] > at[i])) return 0;
  }
  return up ? 1 : -1;
}

std::unique_ptr<HeightSource> heights_over(std::vector<double> x, std::vector<double> y, std::vector<double> z,
                                           const std::string& name) {
  SampleOrder order = SampleOrder::first_row_lowest(x.size());
  if (direction_of(x) < 0) order.turn(x, &SampleOrder::step_x);
  if (direction_of(y) < 0) order.turn(y, &SampleOrder::step_y);
  return held_heights(std::move(x), std::move(y), std::move(z), order, name);
}

std::unique_ptr<HeightSource> matrix_of_rows(const Table& table, RowRange rows, const std::vector<std::size_t>& columns,
                                             const std::string& name, Warnings& warnings) {
  std::vector<double> z;
  z.reserve(rows.size() * columns.size());
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    const std::span<const double> values = table.row(row);
    for (const std::size_t column : columns) z.push_back(values[column]);
  }
  drop_missing_values(z, 1, warnings);
  return held_heights(counted_positions(columns.size()), counted_positions(rows.size()), std::move(z),
                      SampleOrder::first_row_lowest(columns.size()), name);
}

std::unique_ptr<HeightSource> frame_of_rows(const Table& table, RowRange rows, const std::string& name, Warnings& warnings) {
  const std::span<const double> head = table.row(rows.begin);
  if (head.size() < 3 || rows.size() < 3) return nullptr;
  const RowRange body{rows.begin + 1, rows.end};
  std::vector<double> x(head.begin() + 1, head.end()), y = first_column(table, body);
  // If a word begins the first row, the row holds no heights.
  const bool has_word = table.column(0).words > 0 && table.column(0).first_word_row == rows.begin;
  const bool names_columns = direction_of(x) == 0, names_rows = direction_of(y) == 0;
  if ((names_columns || names_rows) && !has_word) return nullptr;
  if (names_columns) x = counted_positions(x.size());
  if (names_rows) y = counted_positions(y.size());
  std::vector<double> z = heights_behind(table, body, warnings);
  warnings.leave_out("head row", names_columns);
  warnings.leave_out("column of row names", names_rows);
  warnings.add("rows and columns of numbers read as positions", !names_columns + !names_rows);
  return heights_over(std::move(x), std::move(y), std::move(z), name);
}

std::unique_ptr<HeightSource> frame_of_names(const Table& table, RowRange rows, const std::vector<double>& positions,
                                             const std::string& name, Warnings& warnings) {
  std::vector<double> y = first_column(table, rows);
  const bool names_rows = table.column(0).is_text() && direction_of(y) == 0;
  if (names_rows) y = counted_positions(y.size());
  if (rows.size() < 2 || direction_of(y) == 0) return nullptr;
  std::vector<double> z = heights_behind(table, rows, warnings);
  warnings.leave_out("column of row names", names_rows);
  warnings.add("rows and columns of numbers read as positions", names_rows ? 1 : 2);
  return heights_over(positions, std::move(y), std::move(z), name);
}

bool is_counted_frame(const Table& table, RowRange rows) {
  const std::span<const double> head = table.row(rows.begin);
  if (head.size() < 3 || rows.size() < 3 || head[0] != static_cast<double>(head.size() - 1)) return false;
  const std::vector<double> x(head.begin() + 1, head.end());
  return direction_of(x) != 0 && direction_of(first_column(table, {rows.begin + 1, rows.end})) != 0;
}

}  // namespace ligne
