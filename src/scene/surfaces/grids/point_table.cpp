#include "scene/surfaces/grids/point_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "files/message_text.hpp"
#include "files/utf16.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/data_file.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/tables/column_names.hpp"
#include "scene/tables/data_array.hpp"
#include "scene/tables/table.hpp"
#include "scene/tables/unpack.hpp"

namespace ligne {
namespace {

/// Reads points from files of arrays.

/// The numbers of one column, `step` elements apart.
struct NumberColumn {
  const DataArray* array = nullptr;
  std::size_t begin = 0, step = 1;

  double operator[](std::size_t row) const { return array->values[begin + row * step]; }
};

class ArrayPoints {
 public:
  ArrayPoints(const std::vector<DataArray>& arrays, const std::vector<TextColumn>& texts, const std::string& name,
              Warnings& warnings)
      : arrays_(arrays), texts_(texts), name_(name), warnings_(warnings) {
    for (const DataArray& array : arrays) {
      std::vector<std::size_t> shape = array.shape;
      std::erase(shape, 1);
      shapes_.push_back(array.layers == 1 ? shape : array.shape);
    }
  }

  std::vector<std::optional<LabelledPoint>> read() {
    if (!find_columns()) take_rows_of_points();
    find_label();
    warn_of_others();
    std::vector<std::optional<LabelledPoint>> points(count_);
    std::size_t without = 0;
    for (std::size_t row = 0; row < count_; ++row) {
      const LabelledPoint point{{x_[row], y_[row], z_ ? (*z_)[row] : kNoHeight}, label_ ? label_->cells[row] : ""};
      const bool is_point = std::isfinite(point.at.x) && std::isfinite(point.at.y);
      if (is_point) points[row] = point;
      without += !is_point;
    }
    warnings_.leave_out("rows without x or y", without);
    return points;
  }

 private:
  bool is_column(std::size_t k) const { return shapes_[k].size() == 1 && arrays_[k].values.size() == shapes_[k][0]; }

  /// Finds x, y and z by the names of one-dimensional arrays; false if no names say x and y.
  bool find_columns() {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < arrays_.size(); ++k) names.push_back(is_column(k) ? arrays_[k].name : std::string());
    const NamedColumns role = named_columns(names);
    if (!role.x || !role.y) return false;
    count_ = arrays_[*role.x].values.size();
    if (arrays_[*role.y].values.size() != count_) {
      throw InputError(name_, "arrays " + printable(names[*role.x]) + " and " + printable(names[*role.y]) +
                                  " have different lengths: they are not positions of points");
    }
    x_ = {&arrays_[*role.x]};
    y_ = {&arrays_[*role.y]};
    if (role.z && arrays_[*role.z].values.size() == count_) z_ = NumberColumn{&arrays_[*role.z]};
    return true;
  }

  /// Takes the points from a single array with one row per point.
  void take_rows_of_points() {
    const std::size_t matrices = static_cast<std::size_t>(
        std::count_if(shapes_.begin(), shapes_.end(), [](const auto& shape) { return shape.size() == 2; }));
    const auto found = std::find_if(shapes_.begin(), shapes_.end(),
                                    [](const auto& shape) { return shape.size() == 2 && (shape[1] == 2 || shape[1] == 3); });
    if (matrices != 1 || found == shapes_.end()) throw no_points();
    const DataArray& array = arrays_[static_cast<std::size_t>(found - shapes_.begin())];
    if (array.values.size() != (*found)[0] * (*found)[1]) throw no_points();
    const std::size_t step = (*found)[1];
    count_ = (*found)[0];
    x_ = {&array, 0, step};
    y_ = {&array, 1, step};
    if (step == 3) z_ = NumberColumn{&array, 2, step};
    warnings_.add(step == 3 ? "columns of the array read as x, y and z" : "columns of the array read as x and y", step);
  }

  InputError no_points() const {
    std::string list;
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      list += (list.empty() ? "" : ", ") + (arrays_[k].name.empty() ? std::string("array") : printable(arrays_[k].name));
      for (std::size_t i = 0; i < shapes_[k].size(); ++i) list += (i == 0 ? " of " : " x ") + std::to_string(shapes_[k][i]);
    }
    return {name_, "holds no points: arrays x and y, or rows of x, y and perhaps z; there are " +
                       (list.empty() ? "none of numbers" : list)};
  }

  /// Finds the label: the column with the name of a label, or the first one of words.
  void find_label() {
    std::vector<std::string> names;
    for (const TextColumn& text : texts_) names.push_back(text.cells.size() == count_ ? text.name : std::string());
    const std::optional<std::size_t> named = named_columns(names).label;
    for (std::size_t k = 0; k < texts_.size() && !label_; ++k) {
      if (texts_[k].cells.size() == count_ && (!named || *named == k)) label_ = &texts_[k];
    }
  }

  void warn_of_others() {
    for (const DataArray& array : arrays_) {
      const bool is_used = &array == x_.array || &array == y_.array || (z_ && &array == z_->array);
      if (!is_used) warnings_.leave_out("array (" + (array.name.empty() ? "its array" : printable(array.name)) + ")");
    }
    for (const TextColumn& text : texts_) {
      if (&text != label_) warnings_.leave_out("column of words (" + printable(text.name) + ")");
    }
  }

  const std::vector<DataArray>& arrays_;
  const std::vector<TextColumn>& texts_;
  const std::string& name_;
  Warnings& warnings_;
  std::vector<std::vector<std::size_t>> shapes_;  ///< without sides of length 1
  std::size_t count_ = 0;
  NumberColumn x_, y_;
  std::optional<NumberColumn> z_;
  const TextColumn* label_ = nullptr;
};

/// Points from the columns x, y, optional z and label, found by name, or from the rows of one array of two or three
/// columns. A row without a position gives nothing and is counted. Throws InputError("NAME: cause").
std::vector<std::optional<LabelledPoint>> points_of_arrays(const std::vector<DataArray>& arrays,
                                                           const std::vector<TextColumn>& texts, const std::string& name,
                                                           Warnings& warnings) {
  return ArrayPoints(arrays, texts, name, warnings).read();
}

/// Largest size of a file of points in bytes: a page has no room for more points.
constexpr std::uintmax_t kMostBytes = 1u << 26;

/// Index that means no column.
constexpr std::size_t kNoColumn = std::numeric_limits<std::size_t>::max();

/// Reads the rows of a table as points.
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

  /// The point of a row; nothing for a row without a position, which is counted. Throws InputError for a word as
  /// position.
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
      if (z_ != kNoColumn) point.at.z = number(values, z_);
      if (label_ < cells.size()) point.label = label_at(cells);
      // Rows without z may have one cell less.
      const bool is_short = std::isnan(point.at.z) && z_ < cells.size() && point.label.empty();
      if (is_short && cell_value(cells[z_], table_.style().numbers).kind == CellKind::word) point.label = cells[z_];
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

  /// The label of a row. If blanks separate cells, they also occur within a label at the end of the row.
  std::string label_at(const std::vector<std::string>& cells) const {
    std::string label = cells[label_];
    const bool is_last = label_ + 1 == table_.names().size();
    for (std::size_t k = label_ + 1; is_last && table_.style().separator == ' ' && k < cells.size(); ++k) {
      label += " " + cells[k];
    }
    return label;
  }

  void take_names(const NamedColumns& named) {
    x_ = *named.x;
    y_ = *named.y;
    z_ = named.z.value_or(kNoColumn);
    label_ = named.label.value_or(kNoColumn);
    const auto is_used = [&](std::size_t k) { return k == x_ || k == y_ || k == z_ || k == label_; };
    for (std::size_t k = 0; k < table_.columns() && label_ == kNoColumn; ++k) {
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

  /// Takes the first two columns of numbers as x and y, and a column of words before them as the label.
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
    if (is_head) warnings_.add("columns read as x and y: " + shown_column(table_, x_) + ", " + shown_column(table_, y_), 2);
  }

  void check_position(std::size_t row) const {
    const std::vector<std::string> cells = table_.cells(row);
    for (const std::size_t column : {x_, y_}) {
      const bool is_word = column < cells.size() && cell_value(cells[column], table_.style().numbers).kind == CellKind::word;
      if (is_word || (column >= cells.size() && !by_names_))
        throw error_at_line(name_, table_.line(row), "does not begin with two numbers, x and y");
    }
  }

  /// Takes the cells after y: an optional z, and the label.
  void take_rest(std::span<const double> values, const std::vector<std::string>& cells, LabelledPoint& point) const {
    std::size_t next = y_ + 1;
    if (std::isfinite(number(values, next))) point.at.z = values[next];
    if (next < cells.size() && (std::isfinite(point.at.z) || is_missing(cells[next]))) ++next;
    const char* between = table_.style().separator == ' ' ? " " : ", ";
    for (; next < cells.size(); ++next) {
      if (cells[next].empty()) continue;
      point.label += (point.label.empty() ? "" : between) + cells[next];
    }
    if (point.label.empty() && label_ < cells.size()) point.label = cells[label_];
  }

  const Table& table_;
  const std::string& name_;
  Warnings& warnings_;
  bool by_names_ = false;
  std::size_t x_ = 0, y_ = 0, z_ = kNoColumn, label_ = kNoColumn;
};

/// The points of a file, in its order; nothing for a row without a position. Lines end with the blocks.
struct PointFile {
  std::vector<std::optional<LabelledPoint>> rows;
  std::vector<RowRange> blocks;
};

PointFile points_of_table(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings) {
  const Table table = read_table(as_text(bytes, name), name, warnings);
  PointColumnsReader reader(table, name, warnings);
  PointFile points{{}, table.blocks()};
  for (std::size_t row = 0; row < table.rows(); ++row) points.rows.push_back(reader.point(row));
  return points;
}

/// Recognises the format by content, as read_surfaces() does.
PointFile read_point_file(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings) {
  constexpr char kWanted[] = "a file of points";
  const std::string_view chars = as_characters(bytes);
  if (bytes.empty()) throw InputError(name, "is empty");
  if (chars.starts_with("PK\x03\x04")) refuse_models(bytes, name, kWanted);
  if (const std::optional<UnpackedFile> inner = unpacked(bytes, name)) {
    if (unpacked(inner->bytes, name)) throw InputError(name, "is an archive within an archive: unpack it");
    return read_point_file(inner->bytes, name, warnings);
  }
  if (const auto raster = raster_name(chars, name)) {
    throw InputError(name, "is " + *raster + ", which holds heights and no points: --grid draws it");
  }
  std::vector<TextColumn> texts;
  if (const auto arrays = read_arrays(bytes, name, 0, kWanted, warnings, &texts)) {
    PointFile points{points_of_arrays(*arrays, texts, name, warnings), {}};
    points.blocks.push_back({0, points.rows.size()});
    return points;
  }
  if (const auto format = foreign_data_format(chars)) throw InputError(name, *format);
  refuse_models(bytes, name, kWanted);
  if (!may_be_text(chars)) {
    throw InputError(name, "is not a known format of points (text tables, npy, netCDF, MATLAB, JSON)");
  }
  return points_of_table(bytes, name, warnings);
}

}  // namespace

std::vector<LabelledPoint> read_points(const std::string& file, InputFiles& opened, Warnings& warnings) {
  const std::string name = printable(file);
  return read_points(as_utf8(read_input(file, name, opened, kMostBytes)), name, warnings);
}

std::vector<LabelledPoint> read_points(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings) {
  PointFile found = read_point_file(bytes, name, warnings);
  std::vector<LabelledPoint> points;
  for (std::optional<LabelledPoint>& point : found.rows) {
    if (point) points.push_back(std::move(*point));
  }
  if (points.empty()) throw InputError(name, "has no points: rows of x, y, and, if not on the surface, z");
  return points;
}

std::vector<std::vector<Point3>> read_lines(const std::string& file, InputFiles& opened, Warnings& warnings) {
  const std::string name = printable(file);
  const PointFile points = read_point_file(as_utf8(read_input(file, name, opened, kMostBytes)), name, warnings);
  std::vector<std::vector<Point3>> lines;
  std::size_t labels = 0;
  for (const RowRange& block : points.blocks) {
    lines.emplace_back();
    for (std::size_t row = block.begin; row < block.end; ++row) {
      const std::optional<LabelledPoint>& point = points.rows[row];
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
