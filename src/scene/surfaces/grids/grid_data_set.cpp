// Makes a surface from the rows of a data set. The names of its columns decide first, then blank lines, then the
// numbers. docs/data-formats.md describes each step.

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/tables/column_names.hpp"

namespace ligne {
namespace {

using PointColumns = std::array<std::size_t, 3>;

constexpr char kColumnHint[] =
    "; --using X:Y:Z says which columns are the positions and the height, --layout matrix that all are heights, "
    "--layout series that all but the first are";

/// Smallest number of rows of two columns that are more likely the points of a curve than heights.
constexpr std::size_t kFewestOfCurve = 8;

/// One data set of a table.
class RowSurface {
 public:
  RowSurface(const Table& table, RowRange rows, const std::string& name, const GridChoice& choice, Warnings& warnings)
      : table_(table), rows_(rows), name_(name), choice_(choice), warnings_(warnings) {}

  GridSurface read() {
    check_even(table_, rows_, name_);
    columns_ = table_.row(rows_.begin).size();
    const std::vector<RowRange>& blocks = table_.blocks();
    auto block = std::lower_bound(blocks.begin(), blocks.end(), rows_.begin,
                                  [](const RowRange& range, std::size_t row) { return range.begin < row; });
    for (; block != blocks.end() && block->begin < rows_.end; ++block) block_begins_.push_back(block->begin - rows_.begin);
    if (choice_.layout == TableLayout::matrix) return {matrix(all_numbers()), {}};
    if (choice_.layout == TableLayout::frame) return {whole_frame(), {}};
    if (choice_.layout == TableLayout::series) return {chosen_series(), {}};
    if (const auto columns = chosen_columns()) return points(*columns);
    return unnamed();
  }

 private:
  InputError error(const std::string& cause) const { return error_at_line(name_, table_.line(rows_.begin), cause); }
  bool is_named() const { return !table_.names().empty() && !table_.names_from_comment(); }
  std::string column_name(std::size_t k) const { return k < table_.names().size() ? table_.names()[k] : std::string(); }
  bool has_numbers(std::size_t k) const { return table_.column(k).numbers > 0; }

  /// The columns of x, y and z chosen by an option or by their names.
  std::optional<PointColumns> chosen_columns() const {
    std::vector<std::size_t> chosen;
    for (const std::string& word : choice_.using_columns) chosen.push_back(column_of(table_, word, name_));
    if (chosen.size() == 3) return PointColumns{chosen[0], chosen[1], chosen[2]};
    std::vector<std::string> names = table_.names();
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (table_.column(k).is_text()) names[k].clear();  // a column of words holds neither positions nor heights
    }
    NamedColumns named = named_columns(names);
    if (!chosen.empty()) named.z = chosen[0];
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < table_.names().size(); ++k) {
      if (k != named.x && k != named.y && k != named.z && has_numbers(k) && !is_index_name(column_name(k)))
        others.push_back(k);
    }
    if (named.x && named.y && !named.z && others.size() == 1) named.z = others.front();
    if (named.x && named.y && named.z) return PointColumns{*named.x, *named.y, *named.z};
    if (named.x && named.y && is_named()) throw no_heights(*named.x, *named.y, others);
    if (choice_.layout != TableLayout::columns && chosen.empty()) return {};
    std::vector<std::size_t> numbers = all_numbers();
    if (!chosen.empty()) std::erase(numbers, chosen[0]);
    if (numbers.size() < (chosen.empty() ? 3 : 2)) throw error("--layout columns needs three columns of numbers");
    return PointColumns{numbers[0], numbers[1], chosen.empty() ? numbers[2] : chosen[0]};
  }

  InputError no_heights(std::size_t x, std::size_t y, const std::vector<std::size_t>& others) const {
    const std::string places = "has positions in columns " + shown_column(table_, x) + " and " + shown_column(table_, y);
    if (others.empty()) return {name_, places + ", and no column of heights; --points FILE marks them on a surface"};
    return {name_, places + ", and no height: --using NAME says which of " + list_of_columns(others) + " it is"};
  }

  std::string list_of_columns(const std::vector<std::size_t>& columns) const {
    constexpr std::size_t kMost = 8;
    std::string list;
    for (std::size_t k = 0; k < std::min(columns.size(), kMost); ++k)
      list += (k == 0 ? "" : ", ") + shown_column(table_, columns[k]);
    return columns.size() > kMost ? list + " ..." : list;
  }

  /// Warns of unused columns, by name.
  void leave_out(const std::vector<std::size_t>& columns) {
    if (columns.empty()) return;
    warnings_.leave_out((columns.size() == 1 ? "column (" : "columns (") + list_of_columns(columns) + ")", columns.size());
  }

  /// The columns of numbers, in their order; columns of words are left out. Throws InputError if a column mixes both.
  std::vector<std::size_t> all_numbers() const {
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < columns_; ++k) {
      const TableColumn& column = table_.column(k);
      if (column.numbers > 0 && column.words > 0) throw word_error(table_, k, name_);
      if (column.words == 0) numbers.push_back(k);
    }
    // Separators at the end of every row make empty last columns, as opposed to signs for missing values.
    const std::vector<std::string> cells = table_.cells(rows_.begin);
    while (numbers.size() > 1 && table_.column(numbers.back()).numbers == 0 && cells[numbers.back()].empty())
      numbers.pop_back();
    return numbers;
  }

  std::unique_ptr<HeightSource> whole_frame() {
    if (const auto at = names_behind_first()) {
      if (auto frame = frame_of_names(table_, rows_, *at, name_, warnings_)) return frame;
    }
    if (auto frame = frame_of_rows(table_, rows_, name_, warnings_)) return frame;
    throw InputError(name_,
                     "has no positions in its first row and first column: they neither ascend nor descend throughout");
  }

  std::optional<std::vector<double>> names_behind_first() const {
    if (table_.names().size() < 3 || table_.names().size() != columns_) return {};
    const std::vector<std::string> names(table_.names().begin() + 1, table_.names().end());
    std::optional<std::vector<double>> at = positions_in_names(names);
    // R names columns without names X1, X2 ...
    if (at && are_numbered(names) && !number_in(names.front()) && at->front() == 1 &&
        at->back() == static_cast<double>(at->size()))
      return {};
    return at;
  }

  /// Makes a surface if neither an option nor the names say what the columns are.
  GridSurface unnamed() {
    if (block_begins_.size() > 1) return blocks();
    if (has_corner()) {
      if (auto frame = frame_of_rows(table_, rows_, name_, warnings_)) return {std::move(frame), {}};
    }
    if (table_.names().empty() && is_counted_frame(table_, rows_)) {
      if (auto frame = frame_of_rows(table_, rows_, name_, warnings_)) return {std::move(frame), {}};
    }
    if (is_named() && (is_position_name(column_name(0)) || is_index_name(column_name(0)))) {
      if (const auto at = names_behind_first()) {
        if (auto frame = frame_of_names(table_, rows_, *at, name_, warnings_)) return {std::move(frame), {}};
      }
    }
    std::vector<std::size_t> numbers = numbers_without_index();
    if (numbers.size() >= 3) {
      if (names_say_series(numbers)) {
        if (auto series = named_series(numbers)) return {std::move(series), {}};
      }
      if (std::optional<GridSurface> found = points_in_order(numbers)) return std::move(*found);
    }
    if (is_named()) check_names(numbers);
    if (auto series = likely_series(numbers)) return {std::move(series), {}};
    if (numbers.size() == 2 && rows_.size() >= kFewestOfCurve)
      warnings_.add("columns read as heights over x = 0 and 1: points of a curve make no surface", 2);
    return {matrix(numbers), {}};
  }

  /// The numbers of some columns, row by row.
  std::vector<double> values_of(const std::vector<std::size_t>& columns) const {
    std::vector<double> values;
    values.reserve(rows_.size() * columns.size());
    for (std::size_t row = rows_.begin; row < rows_.end; ++row) {
      for (const std::size_t column : columns) values.push_back(table_.row(row)[column]);
    }
    return values;
  }

  std::unique_ptr<HeightSource> chosen_series() {
    const std::vector<std::size_t> numbers = all_numbers();
    if (numbers.size() < 3) throw error("a series has a column of positions and two or more of heights");
    if (auto series = series_of_rows(values_of(numbers), numbers.size(), name_, warnings_)) return series;
    throw InputError(name_, "has no positions in its first column: they neither ascend nor descend throughout");
  }

  /// Whether the names are those of a series: "wavelength,s1,s2,s3", or an index that does not number the rows.
  bool names_say_series(const std::vector<std::size_t>& numbers) const {
    if (!is_named()) return false;
    if (is_index_name(column_name(numbers[0]))) return true;
    std::vector<std::string> others;
    for (std::size_t k = 1; k < numbers.size(); ++k) others.push_back(column_name(numbers[k]));
    return is_position_name(column_name(numbers[0])) && are_numbered(others);
  }

  std::unique_ptr<HeightSource> named_series(const std::vector<std::size_t>& numbers) {
    auto series = series_of_rows(values_of(numbers), numbers.size(), name_, warnings_);
    if (series)
      warnings_.add("column (" + shown_column(table_, numbers[0]) + ") read as positions; --layout matrix: heights");
    return series;
  }

  /// A surface whose unnamed first column may hold positions, with a warning of that assumption; null for others.
  std::unique_ptr<HeightSource> likely_series(const std::vector<std::size_t>& numbers) {
    if (numbers.size() < 3) return nullptr;
    const FirstColumn first = kind_of_first_column(values_of(numbers), numbers.size());
    const bool is_position = is_named() && is_position_name(column_name(numbers[0]));
    if (is_position || first == FirstColumn::positions) {
      if (auto series = named_series(numbers)) return series;
    }
    if (is_position || first == FirstColumn::doubtful)
      warnings_.add("column (" + shown_column(table_, numbers[0]) + ") read as heights; --layout series: positions");
    return nullptr;
  }

  /// Whether the first cell is the corner of a frame: no number, followed by numbers. Below names of columns it is the
  /// name of a row instead.
  bool has_corner() const {
    const std::vector<std::string>& names = table_.names();
    if (is_named() && std::any_of(names.begin() + 1, names.end(), [](const std::string& n) { return !n.empty(); }))
      return false;
    const std::span<const double> head = table_.row(rows_.begin);
    if (head.size() < 3 || rows_.begin != 0 || std::isfinite(head[0])) return false;
    return std::all_of(head.begin() + 1, head.end(), [](double v) { return std::isfinite(v); });
  }

  /// Whether a column without a name of its own has even steps and does not just count the rows.
  bool is_axis(std::size_t column) const {
    const std::vector<double> values = values_of({column});
    const bool counts = values.size() > 1 && (values[0] == 0 || values[0] == 1) && values[1] == values[0] + 1;
    return !counts && has_even_steps(values, 1, 0);
  }

  /// The columns of numbers, without those that number or name the rows.
  std::vector<std::size_t> numbers_without_index() {
    std::vector<std::size_t> numbers = all_numbers(), left_out;
    const bool has_index = is_named() && !numbers.empty() && numbers.front() == 0 && columns_ > 2 &&
                           is_index_name(table_.names().front()) && !is_axis(0);
    for (std::size_t k = 0; k < columns_; ++k) {
      if (table_.column(k).is_text() || (k == 0 && has_index)) left_out.push_back(k);
    }
    if (has_index) numbers.erase(numbers.begin());
    if (!table_.names().empty()) {
      leave_out(left_out);
    } else if (!left_out.empty()) {
      warnings_.leave_out(left_out == std::vector<std::size_t>{0} ? "column of row names" : "columns of words",
                          left_out.size());
    }
    return numbers;
  }

  /// Takes the first three columns as x, y and z. If there are more, x and y must form a grid.
  std::optional<GridSurface> points_in_order(const std::vector<std::size_t>& numbers) {
    if (names_are_a_series(numbers)) return {};
    const PointColumns columns{numbers[0], numbers[1], numbers[2]};
    PointRows rows = point_rows(columns);
    rows.block_begins = {0};
    const bool is_grid = find_blocks(rows);
    if (!is_grid && (numbers.size() > 3 || rows_.size() <= 3 || !are_places(rows))) return {};
    if (numbers.size() > 3) leave_out({numbers.begin() + 3, numbers.end()});
    if (is_named()) {
      warnings_.add("columns read as x, y and z: " + list_of_columns({numbers.begin(), numbers.begin() + 3}), 3);
    }
    return surface_without_blocks(std::move(rows));
  }

  bool names_are_a_series(const std::vector<std::size_t>& numbers) const {
    if (table_.names().empty()) return false;
    std::vector<std::string> names;
    names.reserve(numbers.size());
    for (const std::size_t k : numbers) names.push_back(column_name(k));
    return are_numbered(names) || positions_in_names(names);
  }

  /// Requires names that fit a matrix: numbered, in quotes, or beside named rows. Other names mean columns of different
  /// things.
  void check_names(const std::vector<std::size_t>& numbers) {
    const bool has_row_names = is_index_name(table_.names().front());
    bool has_texts = false;  // texts beside row names describe things, such as a species
    for (std::size_t k = 1; k < columns_; ++k) has_texts = has_texts || table_.column(k).is_text();
    const bool has_named_rows = has_row_names || table_.column(0).is_text();
    const bool may_be_matrix = !has_texts && (numbers.size() > 2 || has_named_rows);
    if (((table_.has_quoted_names() || has_row_names) && may_be_matrix) || names_are_a_series(numbers)) {
      warnings_.leave_out("head row");
      return;
    }
    throw error("the columns " + list_of_columns(numbers) + " have unknown names" + kColumnHint);
  }

  std::unique_ptr<HeightSource> matrix(const std::vector<std::size_t>& columns) {
    return matrix_of_rows(table_, rows_, columns, name_, warnings_);
  }

  PointRows point_rows(const PointColumns& columns) const {
    PointRows rows;
    rows.values.reserve(3 * rows_.size());
    for (std::size_t row = rows_.begin; row < rows_.end; ++row) {
      const std::span<const double> values = table_.row(row);
      for (const std::size_t column : columns) rows.values.push_back(values[column]);
      rows.lines.push_back(table_.line(row));
    }
    rows.block_begins = block_begins_;
    drop_missing_values(rows.values, 3, warnings_);
    return rows;
  }

  /// Makes a surface of blocks between blank lines: x, y, z, and further columns.
  GridSurface blocks() {
    const std::vector<std::size_t> numbers = all_numbers();
    if (numbers.size() < 3) {
      throw error("blank lines divide rows of " + std::to_string(columns_) + " columns; blocks of x y z have three");
    }
    PointRows rows = point_rows({numbers[0], numbers[1], numbers[2]});
    // A matrix may have blank lines between rows. In gnuplot, blocks of four columns are a mesh with a colour.
    const bool are_blocks =
        numbers.size() == 3 || (are_even_blocks(rows) && (numbers.size() == 4 || is_grid_of_blocks(rows, name_)));
    if (!are_blocks) {
      throw error_at_line(name_, rows.lines[rows.block_begins[1]],
                          "blank lines before this row of a matrix of " + std::to_string(columns_) +
                              " columns; blocks of x y z have three" + kColumnHint);
    }
    if (numbers.size() > 3) leave_out({numbers.begin() + 3, numbers.end()});
    return surface_of(std::move(rows));
  }

  GridSurface points(const PointColumns& columns) {
    for (const std::size_t column : columns) {
      if (column >= columns_ || table_.column(column).words > 0) {
        if (column < columns_) throw word_error(table_, column, name_);
        throw error("has no column " + std::to_string(column + 1));
      }
    }
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < columns_; ++k) {
      if (std::find(columns.begin(), columns.end(), k) == columns.end()) others.push_back(k);
    }
    leave_out(others);
    PointRows rows = point_rows(columns);
    if (rows.block_begins.size() > 1 && are_even_blocks(rows)) return surface_of(std::move(rows));
    return surface_without_blocks(std::move(rows));
  }

  /// Makes a surface of rows without blank lines, which are not a mesh: heights at repeated places are averaged.
  GridSurface surface_without_blocks(PointRows rows) {
    rows.block_begins = {0};
    if (find_blocks(rows) && is_grid_of_blocks(rows, name_)) return {grid_of_points(std::move(rows), name_), {}};
    rows.block_begins = {0};
    return {surface_of_rows(rows, choice_, name_, warnings_), {}};
  }

  /// Tries, from certain to doubtful: a grid of blocks, a mesh, a grid with holes, scattered points.
  GridSurface surface_of(PointRows rows) {
    const std::vector<std::size_t>& begins = rows.block_begins;
    if (begins.size() < 2) return {surface_of_rows(rows, choice_, name_, warnings_), {}};
    if (begins.size() == rows.lines.size()) {
      throw error("block of a single point; the points of a grid come in blocks of one x or one y each");
    }
    if (are_polygons(rows)) {
      throw InputError(name_,
                       "has blocks that are the polygons of a solid, not scan lines of a surface: write them as OFF "
                       "or OBJ, and draw them with: ligne draw");
    }
    if (are_even_blocks(rows)) {
      if (is_grid_of_blocks(rows, name_)) return {grid_of_points(std::move(rows), name_), {}};
      warnings_.add("rows of a mesh whose x and y both vary", begins.size());
      return {nullptr, mesh_of_blocks(rows, name_)};
    }
    warnings_.add("blocks of different lengths: places without a point are holes", begins.size());
    return {surface_of_rows(rows, choice_, name_, warnings_), {}};
  }

  const Table& table_;
  RowRange rows_;
  const std::string& name_;
  const GridChoice& choice_;
  Warnings& warnings_;
  std::size_t columns_ = 0;
  std::vector<std::size_t> block_begins_;  ///< counted from the first row of the data set
};

}  // namespace

GridSurface surface_of_data_set(const Table& table, RowRange rows, const std::string& name, const GridChoice& choice,
                                Warnings& warnings) {
  return RowSurface(table, rows, name, choice, warnings).read();
}

}  // namespace ligne
