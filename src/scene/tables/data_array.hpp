#pragma once
/// Named arrays of numbers, as binary files and JSON hold them, and their readers.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/diagnostics.hpp"

namespace ligne {

/// The last index varies fastest.
struct DataArray {
  std::string name;
  std::vector<std::size_t> shape;
  std::vector<double> values;             ///< NaN for missing ones
  std::vector<std::string> dimensions{};  ///< names of the axes, where the file has them
  std::string unit{};
  /// `values` may hold one layer of an array of more than two dimensions: shape and dimensions are then those of the layer.
  std::size_t layers = 1;
};

/// A column of words, such as the names of places.
struct TextColumn {
  std::string name;
  std::vector<std::string> cells;  ///< empty where a row has none
};

/// The number of elements; throws InputError where they would take more than `bytes`, with `bytes_each` for one.
std::size_t element_count(std::span<const std::size_t> shape, std::size_t bytes_each, std::size_t bytes,
                          const std::string& name);

/// Values whose first index varies fastest, in the order of DataArray.
std::vector<double> from_column_major(const std::vector<double>& values, std::span<const std::size_t> shape);

/// numpy's .npy: integers, floats of 16 to 64 bits and booleans, of any byte order.
bool is_npy(std::string_view bytes);
DataArray read_npy(std::span<const std::byte> bytes, const std::string& name);

/// netCDF classic, with 64-bit offsets, and with 64-bit data: all variables of numbers. Scales, offsets and fill values are
/// applied. Of more than two dimensions the last two are read, at the `layer`-th index of the others. The ranges of old
/// grids of GMT become arrays of their positions.
bool is_classic_netcdf(std::string_view bytes);
std::vector<DataArray> read_netcdf(std::span<const std::byte> bytes, const std::string& name, std::size_t layer);

/// MATLAB files of the versions 5 to 7: real arrays of numbers. Others are left out by name.
bool is_matlab(std::string_view bytes);
std::vector<DataArray> read_matlab(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings);

/// JSON: rows of numbers, objects of arrays or columns, lists of records, figures of plotly. Columns of words go to `texts`;
/// where that is null they are left out, by name.
bool may_be_json(std::string_view text);
std::vector<DataArray> read_json_arrays(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                        std::vector<TextColumn>* texts = nullptr);

}  // namespace ligne
