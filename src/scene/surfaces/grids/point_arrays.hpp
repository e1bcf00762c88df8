#pragma once
/// Reads points from files of arrays.

#include <optional>
#include <string>
#include <vector>

#include "scene/surfaces/grids/point_table.hpp"
#include "scene/tables/data_array.hpp"

namespace ligne {

/// Points from the columns x, y, optional z and label, found by name, or from the rows of one array of two or three
/// columns. A row without a position gives nothing and is counted. Throws InputError("NAME: cause").
std::vector<std::optional<LabelledPoint>> points_of_arrays(const std::vector<DataArray>& arrays,
                                                           const std::vector<TextColumn>& texts, const std::string& name,
                                                           Warnings& warnings);

}  // namespace ligne
