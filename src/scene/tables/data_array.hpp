#pragma once
/// Named arrays of numbers from binary files and JSON, and their readers.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/diagnostics.hpp"

namespace ligne {

/// An array; its last index varies fastest.
struct DataArray {
  std::string name;
  std::vector<std::size_t> shape;
  std::vector<double> values;             ///< NaN for missing ones
  std::vector<std::string> dimensions{};  ///< names of the axes, if the file has them
  std::string unit{};
  /// If `values` hold one layer of an array of more than two dimensions, shape and dimensions are those of the layer.
  std::size_t layers = 1;
};

/// A column of words, such as the names of places.
struct TextColumn {
  std::string name;
  std::vector<std::string> cells;  ///< empty if a row has none
};

/// The number of elements. Throws InputError if they would take more than `bytes`, at `bytes_each` per element.
std::size_t element_count(std::span<const std::size_t> shape, std::size_t bytes_each, std::size_t bytes,
                          const std::string& name);

/// Reorders values whose first index varies fastest to the order of DataArray.
std::vector<double> from_column_major(const std::vector<double>& values, std::span<const std::size_t> shape);

/// numpy's .npy: integers, floats of 16 to 64 bits and booleans, of any byte order.
bool is_npy(std::string_view bytes);
DataArray read_npy(std::span<const std::byte> bytes, const std::string& name);
/// numpy's .npz: an archive of such files alone. Warns of arrays that can not be read.
inline constexpr std::string_view kNpySuffix = ".npy";
std::vector<DataArray> read_npz(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings);

/// netCDF classic, with 64-bit offsets, and with 64-bit data: all numeric variables. Applies scales, offsets and fill
/// values. Of arrays of more than two dimensions it reads the last two, at the `layer`-th index of the others. The
/// ranges of old grids of GMT become arrays of positions.
bool is_classic_netcdf(std::string_view bytes);
std::vector<DataArray> read_netcdf(std::span<const std::byte> bytes, const std::string& name, std::size_t layer);

/// MATLAB files of the versions 5 to 7: real numeric arrays. Warns of others by name.
bool is_matlab(std::string_view bytes);
std::vector<DataArray> read_matlab(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings);

/// JSON: rows of numbers, objects of arrays or columns, lists of records, figures of plotly. Columns of words go to
/// `texts`; if that is null, a warning names them.
bool may_be_json(std::string_view text);
std::vector<DataArray> read_json_arrays(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                        std::vector<TextColumn>* texts = nullptr);

/// Arrays as text: [1 2; 3 4] of MATLAB, {{1, 2}, {3, 4}} of C, and what numpy prints, each perhaps with a name and "=".
/// read_json_arrays() reads those without names too.
bool may_be_text_arrays(std::string_view text);
std::vector<DataArray> read_text_arrays(std::string_view text, const std::string& name);

}  // namespace ligne
