#pragma once
/// The kind of a file of data, by its content.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/tables/data_array.hpp"

namespace ligne {

/// The digit of a Netpbm picture, which begins with 'P', a digit and white space; 0 for other files.
char netpbm_kind(std::string_view chars);

/// A TIFF in either byte order and size, or HDF5 where GDAL is in the build; elsewhere data_stranger() names HDF5.
bool is_for_gdal(std::string_view chars);

/// "a PNG picture", "a grid of Surfer": the name of a file that holds a grid of heights and no points; nothing for others.
std::optional<std::string> raster_name(std::string_view chars, const std::string& name);

/// False for bytes that no text has, in the first 64 KiB.
bool may_be_text(std::string_view chars);

/// Throws InputError when the bytes are a model, or a file of another known kind. `wanted` is a noun: "a grid of heights".
void refuse_models(std::span<const std::byte> bytes, const std::string& name, const std::string& wanted);

/// The arrays of .npy, netCDF (at index `layer` of the dimensions before the last two), MATLAB and JSON; nothing for other
/// bytes. Columns of texts go to `texts` where JSON has them, or are left out where that is null. Throws InputError.
std::optional<std::vector<DataArray>> read_arrays(std::span<const std::byte> bytes, const std::string& name,
                                                  std::size_t layer, const std::string& wanted, Warnings& warnings,
                                                  std::vector<TextColumn>* texts = nullptr);

}  // namespace ligne
