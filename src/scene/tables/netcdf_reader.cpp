// A value is the number in the file times scale_factor plus add_offset; numbers equal to the fill value are missing.

#include <algorithm>
#include <cmath>
#include <limits>

#include "files/message_text.hpp"
#include "scene/tables/data_array.hpp"
#include "scene/tables/netcdf_header.hpp"

namespace ligne {
namespace {

/// Numbers from here on are missing: the netCDF library fills unwritten floats and doubles with them, and no quantity
/// is as large.
constexpr double kDefaultFill = 9.96e36;

double number_of(const NetcdfAttributes& attributes, const char* name, double otherwise) {
  const auto found = attributes.find(name);
  return found == attributes.end() || found->second.numbers.empty() ? otherwise : found->second.numbers.front();
}

/// Converts the numbers of a file to values.
struct ValueScale {
  double factor = 1, offset = 0;
  std::vector<double> missing;

  explicit ValueScale(const NetcdfAttributes& attributes)
      : factor(number_of(attributes, "scale_factor", 1)), offset(number_of(attributes, "add_offset", 0)) {
    for (const char* name : {"_FillValue", "missing_value"}) {
      const auto found = attributes.find(name);
      if (found != attributes.end())
        missing.insert(missing.end(), found->second.numbers.begin(), found->second.numbers.end());
    }
  }

  double operator()(double number) const {
    const bool is_missing = !std::isfinite(number) || std::abs(number) > kDefaultFill ||
                            std::find(missing.begin(), missing.end(), number) != missing.end();
    const double value = number * factor + offset;
    return is_missing || !std::isfinite(value) ? std::numeric_limits<double>::quiet_NaN() : value;
  }
};

/// One layer of a variable: its last two dimensions, or all if there are no more.
DataArray layer_of(const NetcdfHeader& header, const NetcdfVariable& variable, std::span<const std::byte> bytes,
                   std::size_t layer, const std::string& name) {
  DataArray array;
  array.name = variable.name;
  const auto unit = variable.attributes.find("units");
  if (unit != variable.attributes.end()) array.unit = unit->second.text;
  const std::size_t axes = variable.dimensions.size();
  for (std::size_t k = 0; k < axes; ++k) {
    const NetcdfDimension& dimension = header.dimensions[variable.dimensions[k]];
    if (k + 2 < axes) {
      if (dimension.size != 0 && array.layers > bytes.size() / dimension.size) throw InputError(name, "is truncated");
      array.layers *= dimension.size;
      continue;
    }
    array.shape.push_back(dimension.size);
    array.dimensions.push_back(dimension.name);
  }
  const std::size_t each = bytes_of(variable.type);
  const std::size_t count = element_count(array.shape, each, bytes.size(), name);
  if (layer >= array.layers || count == 0) return array;
  // Records of one variable are not adjacent: those of other variables lie between them.
  const std::size_t first = layer * count;
  std::size_t per_record = 1;
  for (std::size_t k = 1; k < axes; ++k) per_record *= header.dimensions[variable.dimensions[k]].size;
  const ValueScale scale(variable.attributes);
  array.values.reserve(count);
  for (std::size_t k = first; k < first + count; ++k) {
    const std::size_t at = variable.is_record ? variable.begin + k / per_record * header.record_bytes + k % per_record * each
                                              : variable.begin + k * each;
    if (at > bytes.size() || bytes.size() - at < each) {
      throw InputError(name, "is truncated: variable " + shown(variable.name) + " extends past the end of the file");
    }
    array.values.push_back(scale(netcdf_value(bytes.data() + at, variable.type)));
  }
  return array;
}

/// Reads grids of GMT before version 4: x_range, y_range and spacing, and z as one row, north first.
void restore_old_gmt(const NetcdfHeader& header, std::vector<DataArray>& arrays, const std::string& name) {
  const auto find = [&](const char* wanted) -> DataArray* {
    const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const DataArray& a) { return a.name == wanted; });
    return found == arrays.end() || found->values.empty() ? nullptr : &*found;
  };
  DataArray *x_range = find("x_range"), *y_range = find("y_range"), *counts = find("dimension"), *z = find("z");
  if (!x_range || !y_range || !counts || !z || x_range->values.size() < 2 || y_range->values.size() < 2 ||
      counts->values.size() < 2)
    return;
  const double columns = counts->values[0], rows = counts->values[1];
  if (!(columns >= 2 && rows >= 2) || columns * rows != static_cast<double>(z->values.size())) {
    throw InputError(name, "is a grid of GMT whose dimension does not fit its heights");
  }
  const auto variable =
      std::find_if(header.variables.begin(), header.variables.end(), [](const NetcdfVariable& v) { return v.name == "z"; });
  const bool by_pixels = number_of(variable->attributes, "node_offset", 0) != 0;
  const auto positions = [&](const char* axis, const DataArray& range, double count) {
    const double step = (range.values[1] - range.values[0]) / (by_pixels ? count : count - 1);
    DataArray at{axis, {static_cast<std::size_t>(count)}, {}, {axis}};
    for (double k = 0; k < count; ++k) at.values.push_back(range.values[0] + (by_pixels ? k + 0.5 : k) * step);
    return at;
  };
  DataArray y = positions("y", *y_range, rows),
            heights{"z", {y.shape[0], static_cast<std::size_t>(columns)}, z->values, {"y", "x"}};
  std::reverse(y.values.begin(), y.values.end());
  DataArray x = positions("x", *x_range, columns);
  arrays = {std::move(x), std::move(y), std::move(heights)};
}

}  // namespace

bool is_classic_netcdf(std::string_view bytes) {
  return bytes.starts_with("CDF") && bytes.size() > 3 && (bytes[3] == 1 || bytes[3] == 2 || bytes[3] == 5);
}

std::vector<DataArray> read_netcdf(std::span<const std::byte> bytes, const std::string& name, std::size_t layer) {
  const NetcdfHeader header = read_netcdf_header(bytes, name);
  std::vector<DataArray> arrays;
  std::size_t taken = 0;
  for (const NetcdfVariable& variable : header.variables) {
    if (variable.type == NetcdfType::character || variable.dimensions.empty()) continue;
    arrays.push_back(layer_of(header, variable, bytes, variable.dimensions.size() > 2 ? layer : 0, name));
    // In a forged file, variables may overlap.
    taken += arrays.back().values.size() * bytes_of(variable.type);
    if (taken > bytes.size()) throw InputError(name, "has variables whose total size exceeds the file");
  }
  restore_old_gmt(header, arrays, name);
  return arrays;
}

}  // namespace ligne
