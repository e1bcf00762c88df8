// Makes surfaces of arrays: of a two-dimensional one at its positions, or of three one-dimensional ones as points.

#include <algorithm>
#include <cmath>

#include "files/message_text.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"
#include "scene/tables/column_names.hpp"

namespace ligne {
namespace {

/// Largest difference of repeated positions in a mesh grid, relative to the largest position; allows single precision.
constexpr double kSameInMeshgrid = 0x1p-20;

/// Transposes the array.
void transpose(DataArray& array) {
  const std::size_t rows = array.shape[0], columns = array.shape[1];
  std::vector<double> turned(array.values.size());
  for (std::size_t k = 0; k < turned.size(); ++k) turned[k] = array.values[k % rows * columns + k / rows];
  array.values = std::move(turned);
  std::swap(array.shape[0], array.shape[1]);
  if (array.dimensions.size() == 2) std::swap(array.dimensions[0], array.dimensions[1]);
}

/// Continues longitudes that ascend past 180 or 360 degrees and jump to the other end, without the jump.
std::vector<double> unwrapped_longitudes(std::vector<double> degrees) {
  if (std::is_sorted(degrees.begin(), degrees.end()) || std::is_sorted(degrees.rbegin(), degrees.rend())) return degrees;
  for (std::size_t k = 1; k < degrees.size(); ++k) {
    if (degrees[k - 1] - degrees[k] > 180) degrees[k] += 360;
  }
  return degrees;
}

class ArraySurface {
 public:
  ArraySurface(std::vector<DataArray> arrays, const std::string& name, const GridChoice& choice, Warnings& warnings)
      : arrays_(std::move(arrays)), name_(name), choice_(choice), warnings_(warnings) {
    for (DataArray& array : arrays_) {
      take_layer(array);
      std::erase(array.shape, 1);
    }
  }

  GridSurface read() {
    const DataArray* z = heights();
    if (!z) return points();
    // An array of points in numpy has one row per point.
    if (arrays_.size() == 1 && z->name.empty() && z->shape[1] == 3 && choice_.layout != TableLayout::matrix) {
      if (std::optional<GridSurface> found = rows_of_points(*z)) return std::move(*found);
    }
    if (arrays_.size() == 1) {
      if (auto series = series_of(*z)) return {std::move(series), {}};
    }
    if (has_columns_along_x(*z)) transpose(arrays_[static_cast<std::size_t>(z - arrays_.data())]);
    const DataArray *x = positions(*z, 1), *y = positions(*z, 0);
    leave_out_others({z, x, y});
    if (x && y && x->shape.size() == 2 && y->shape.size() == 2) {
      if (!is_meshgrid(*x, true) || !is_meshgrid(*y, false)) return mesh(*x, *y, *z);
    }
    std::vector<double> values = z->values;
    drop_missing_values(values, 1, warnings_);
    auto heights = heights_over(axis(*z, x, 1), axis(*z, y, 0), std::move(values), name_);
    if (is_degrees(x, "_east") && is_degrees(y, "_north")) heights->set_unit(GroundUnit::degrees);
    return {std::move(heights), {}};
  }

 private:
  static std::string shown_name(const DataArray& array) { return array.name.empty() ? "its array" : printable(array.name); }

  /// Reduces an array to its last two dimensions, at one index of the others.
  void take_layer(DataArray& array) {
    if (array.values.empty()) return;
    while (array.shape.size() > 2 && (array.shape.back() == 1)) array.shape.pop_back();
    if (array.shape.size() <= 2) return;
    const std::size_t size = array.shape[array.shape.size() - 1] * array.shape[array.shape.size() - 2];
    if (size == 0) return;
    array.layers = array.values.size() / size;
    const std::size_t layer = choice_.data_set.value_or(0);
    if (layer < array.layers) {
      array.values.erase(array.values.begin(), array.values.begin() + static_cast<std::ptrdiff_t>(layer * size));
      array.values.resize(size);
    } else {
      array.values.clear();
    }
    array.shape.erase(array.shape.begin(), array.shape.end() - 2);
  }

  const DataArray* find(std::string_view name) const {
    const auto found = std::ranges::find_if(arrays_, [&](const DataArray& a) { return equal_ignoring_case(a.name, name); });
    return found == arrays_.end() ? nullptr : &*found;
  }
  const DataArray& chosen(const std::string& name) const {
    if (const DataArray* array = find(name)) return *array;
    std::string names;
    for (const DataArray& array : arrays_) names += (names.empty() ? "" : ", ") + shown_name(array);
    throw InputError(name_, "has no array " + shown(name) + ": there are " + names);
  }

  static bool is_matrix(const DataArray& array) {
    return array.shape.size() == 2 && array.shape[0] >= 2 && array.shape[1] >= 2;
  }

  /// The two-dimensional array chosen by an option or by its name, or the only one; null if there is none.
  const DataArray* heights() {
    const std::vector<std::string>& names = choice_.using_columns;
    const DataArray* z = names.empty() ? nullptr : &chosen(names.back());
    if (z && !is_matrix(*z)) return nullptr;
    std::vector<const DataArray*> matrices;
    for (const DataArray& array : arrays_) {
      const NamedColumns role = named_columns({array.name});
      if (is_matrix(array) && !role.x && !role.y && !is_bounds(array)) matrices.push_back(&array);
    }
    if (!z && matrices.empty()) {
      const auto any = std::ranges::find_if(arrays_, is_matrix);
      if (any != arrays_.end()) z = &*any;
    }
    for (const DataArray* array : matrices) {
      if (!z && (matrices.size() == 1 || named_columns({array->name}).z)) z = array;
    }
    if (!z && !matrices.empty()) {
      std::string list;
      for (const DataArray* array : matrices) list += (list.empty() ? "" : ", ") + shown_name(*array);
      throw InputError(name_, "holds several arrays: " + list + "; --using NAME takes one");
    }
    if (!z) return nullptr;
    if (z->values.empty()) {
      throw InputError(name_, "array " + shown_name(*z) + " has " + std::to_string(z->layers) +
                                  " layers, numbered from 0, and none of number " +
                                  std::to_string(choice_.data_set.value_or(0)));
    }
    if (z->layers > 1 && !choice_.data_set) warnings_.leave_out("layers of " + shown_name(*z), z->layers - 1);
    return z;
  }

  /// Whether an array holds the ends of the cells of an axis, in netCDF.
  static bool is_bounds(const DataArray& array) {
    return array.shape[1] == 2 && (array.name.ends_with("_bnds") || array.name.ends_with("_bounds"));
  }

  /// Whether x belongs to the first index: the names of the axes say so, or the positions only fit so.
  bool has_columns_along_x(const DataArray& z) const {
    const auto fits = [&](const DataArray* array, std::size_t dimension) {
      return array && array->shape.size() == 1 && array->shape[0] == z.shape[dimension];
    };
    if (choice_.using_columns.size() == 3) {
      const DataArray &x = chosen(choice_.using_columns[0]), &y = chosen(choice_.using_columns[1]);
      return z.shape[0] != z.shape[1] && fits(&x, 0) && fits(&y, 1);
    }
    if (z.dimensions.size() == 2) {
      return fits(find(z.dimensions[0]), 0) && fits(find(z.dimensions[1]), 1) && named_columns({z.dimensions[0]}).x &&
             named_columns({z.dimensions[1]}).y;
    }
    const DataArray *x = nullptr, *y = nullptr;
    for (const DataArray& array : arrays_) {
      const NamedColumns role = named_columns({array.name});
      if (!x && role.x) x = &array;
      if (!y && role.y) y = &array;
    }
    return z.shape[0] != z.shape[1] && fits(x, 0) && fits(y, 1);
  }

  /// The positions along a dimension: from an option, from netCDF's coordinate variable, or from an array named for it.
  const DataArray* positions(const DataArray& z, std::size_t dimension) const {
    const auto fits = [&](const DataArray& array) {
      return &array != &z && !array.values.empty() &&
             ((array.shape.size() == 1 && array.shape[0] == z.shape[dimension]) || array.shape == z.shape);
    };
    if (choice_.using_columns.size() == 3) {
      const DataArray& array = chosen(choice_.using_columns[dimension == 1 ? 0 : 1]);
      if (!fits(array)) throw InputError(name_, "array " + shown_name(array) + " has another size than " + shown_name(z));
      return &array;
    }
    if (z.dimensions.size() == 2) {
      const DataArray* array = find(z.dimensions[dimension]);
      if (array && array->shape.size() == 1 && fits(*array)) return array;
    }
    for (const DataArray& array : arrays_) {
      const NamedColumns role = named_columns({array.name});
      if (fits(array) && (dimension == 1 ? role.x : role.y)) return &array;
    }
    return nullptr;
  }

  void leave_out_others(std::initializer_list<const DataArray*> used) {
    for (const DataArray& array : arrays_) {
      if (std::ranges::find(used, &array) != used.end() || array.shape.empty()) continue;
      warnings_.leave_out("array (" + shown_name(array) + ")");
    }
  }

  /// Whether the unit is "degrees_east" or "degree_east", with the given direction, as in netCDF's conventions.
  static bool is_degrees(const DataArray* array, std::string_view direction) {
    return array && array->unit.starts_with("degree") && array->unit.ends_with(direction);
  }

  /// Whether all rows are equal, or all columns.
  static bool is_meshgrid(const DataArray& array, bool rows_alike) {
    const std::size_t columns = array.shape[1];
    double most = 0;
    for (const double value : array.values) most = std::max(most, std::abs(value));
    for (std::size_t k = 0; k < array.values.size(); ++k) {
      const double expected = array.values[rows_alike ? k % columns : k - k % columns];
      if (!(std::abs(array.values[k] - expected) <= kSameInMeshgrid * most)) return false;
    }
    return true;
  }

  std::vector<double> axis(const DataArray& z, const DataArray* at, std::size_t dimension) const {
    const std::size_t count = z.shape[dimension];
    if (!at) return counted_positions(count);
    if (at->shape.size() == 1) return is_degrees(at, "_east") ? unwrapped_longitudes(at->values) : at->values;
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k) values.push_back(at->values[dimension == 1 ? k : k * z.shape[1]]);
    return values;
  }

  GridSurface mesh(const DataArray& x, const DataArray& y, const DataArray& z) {
    PointRows rows;
    for (std::size_t k = 0; k < z.values.size(); ++k) {
      if (k % z.shape[1] == 0) rows.block_begins.push_back(k);
      rows.lines.push_back(k);
      rows.values.insert(rows.values.end(), {x.values[k], y.values[k], z.values[k]});
    }
    warnings_.add("rows of a mesh whose x and y both vary", z.shape[0]);
    GridSurface surface{nullptr, mesh_of_blocks(rows, name_)};
    if (is_degrees(&x, "_east") && is_degrees(&y, "_north")) surface.mesh->unit = GroundUnit::degrees;
    return surface;
  }

  GridSurface surface_of(const std::array<const std::vector<double>*, 3>& columns) {
    PointRows rows;
    for (std::size_t k = 0; k < columns[0]->size(); ++k) {
      rows.lines.push_back(k + 1);
      for (const std::vector<double>* column : columns) rows.values.push_back((*column)[k]);
    }
    drop_missing_values(rows.values, 3, warnings_);
    rows.block_begins = {0};
    if (find_blocks(rows) && is_grid_of_blocks(rows, name_)) return {grid_of_points(std::move(rows), name_), {}};
    rows.block_begins = {0};
    return {surface_of_rows(rows, choice_, name_, warnings_), {}};
  }

  /// Makes a surface of the three columns of one array.
  std::optional<GridSurface> rows_of_points(const DataArray& array) {
    std::array<std::vector<double>, 3> columns;
    PointRows rows;
    for (std::size_t k = 0; k < array.values.size(); ++k) columns[k % 3].push_back(array.values[k]);
    rows.values = array.values;
    for (std::size_t k = 0; k < array.shape[0]; ++k) rows.lines.push_back(k + 1);
    rows.block_begins = {0};
    const bool are_points = array.shape[0] > 3 && (find_blocks(rows) || are_places(rows));
    if (!are_points && choice_.layout != TableLayout::columns) return {};
    warnings_.add("columns of the array read as x, y and z", 3);
    return surface_of({&columns[0], &columns[1], &columns[2]});
  }

  /// A surface of a single array whose first column holds positions; null for others.
  std::unique_ptr<HeightSource> series_of(const DataArray& array) {
    const std::size_t columns = array.shape[1];
    const bool is_chosen = choice_.layout == TableLayout::series;
    if (columns < 3 || !(is_chosen || choice_.layout == TableLayout::automatic)) return nullptr;
    const FirstColumn first = kind_of_first_column(array.values, columns);
    if (!is_chosen && first == FirstColumn::doubtful)
      warnings_.add("column (1) read as heights; --layout series: positions");
    if (!is_chosen && first != FirstColumn::positions) return nullptr;
    auto series = series_of_rows(array.values, columns, name_, warnings_);
    if (!series) throw InputError(name_, "has no positions in its first column: they neither ascend nor descend throughout");
    if (!is_chosen) warnings_.add("column (1) read as positions; --layout matrix: heights");
    return series;
  }

  /// Makes a surface of one-dimensional arrays of equal length.
  GridSurface points() {
    std::vector<std::string> names;
    for (const DataArray& array : arrays_) names.push_back(array.shape.size() == 1 ? array.name : std::string());
    NamedColumns role = named_columns(names);
    const std::vector<std::string>& chosen_names = choice_.using_columns;
    const auto number = [&](const std::string& name) { return static_cast<std::size_t>(&chosen(name) - arrays_.data()); };
    if (chosen_names.size() == 3) role.x = number(chosen_names[0]), role.y = number(chosen_names[1]);
    if (!chosen_names.empty()) role.z = number(chosen_names.back());
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < arrays_.size(); ++k) {
      if (arrays_[k].shape.size() == 1 && k != role.x && k != role.y && k != role.z && !is_index_name(arrays_[k].name))
        others.push_back(k);
    }
    if (role.x && role.y && !role.z && others.size() == 1) role.z = others[0];
    if (!role.x || !role.y || !role.z) {
      std::string list;
      for (const DataArray& array : arrays_) list += (list.empty() ? "" : ", ") + shown_name(array);
      throw InputError(name_, "holds no array of heights of two dimensions, and no x, y and z" +
                                  (list.empty() ? "" : ": there are " + list));
    }
    const DataArray &x = arrays_[*role.x], &y = arrays_[*role.y], &z = arrays_[*role.z];
    if (x.values.size() != y.values.size() || x.values.size() != z.values.size() || x.values.empty()) {
      throw InputError(
          name_, "arrays " + shown_name(x) + ", " + shown_name(y) + " and " + shown_name(z) + " have different lengths");
    }
    leave_out_others({&x, &y, &z});
    return surface_of({&x.values, &y.values, &z.values});
  }

  std::vector<DataArray> arrays_;
  const std::string& name_;
  const GridChoice& choice_;
  Warnings& warnings_;
};

}  // namespace

GridSurface surface_of_arrays(std::vector<DataArray> arrays, const std::string& name, const GridChoice& choice,
                              Warnings& warnings) {
  return ArraySurface(std::move(arrays), name, choice, warnings).read();
}

}  // namespace ligne
