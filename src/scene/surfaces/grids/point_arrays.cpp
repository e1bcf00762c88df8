#include "scene/surfaces/grids/point_arrays.hpp"

#include <algorithm>
#include <cmath>

#include "files/message_text.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/tables/column_names.hpp"

namespace ligne {
namespace {

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

}  // namespace

std::vector<std::optional<LabelledPoint>> points_of_arrays(const std::vector<DataArray>& arrays,
                                                           const std::vector<TextColumn>& texts, const std::string& name,
                                                           Warnings& warnings) {
  return ArrayPoints(arrays, texts, name, warnings).read();
}

}  // namespace ligne
