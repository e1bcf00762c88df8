#pragma once
/// Recognises the kind of a data file by its content.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/tables/data_array.hpp"

namespace ligne {

/// The digit of a Netpbm picture, which begins with 'P', the digit and white space; 0 for other files.
char netpbm_kind(std::string_view chars);

/// Whether the bytes are a TIFF of either byte order and size, or HDF5 if GDAL is in the build; otherwise
/// foreign_data_format() reports HDF5.
bool is_for_gdal(std::string_view chars);

/// The kind of a file that holds a grid of heights and no points, such as "a PNG picture"; nothing for others.
std::optional<std::string> raster_name(std::string_view chars, const std::string& name);

/// False if the first 64 KiB hold bytes that no text has.
bool may_be_text(std::string_view chars);

/// Throws InputError if the bytes are a model or another known kind of file. `wanted` is a noun: "a grid of heights".
void refuse_models(std::span<const std::byte> bytes, const std::string& name, const std::string& wanted);

/// The arrays of .npy, netCDF (at index `layer` of the dimensions before the last two), MATLAB and JSON; nothing for
/// other bytes. Text columns of JSON go to `texts`, or are left out if that is null. Throws InputError.
std::optional<std::vector<DataArray>> read_arrays(std::span<const std::byte> bytes, const std::string& name,
                                                  std::size_t layer, const std::string& wanted, Warnings& warnings,
                                                  std::vector<TextColumn>* texts = nullptr);

}  // namespace ligne
