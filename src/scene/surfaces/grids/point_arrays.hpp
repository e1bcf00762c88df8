#pragma once
/// Points in files of arrays.

#include <optional>
#include <string>
#include <vector>

#include "scene/surfaces/grids/point_table.hpp"
#include "scene/tables/data_array.hpp"

namespace ligne {

/// The columns x, y, perhaps z and a label, by their names; or the rows of one array of two or three columns. Nothing for
/// rows without a position, which are counted. Throws InputError("NAME: cause").
std::vector<std::optional<LabelledPoint>> points_of_arrays(const std::vector<DataArray>& arrays,
                                                           const std::vector<TextColumn>& texts, const std::string& name,
                                                           Warnings& warnings);

}  // namespace ligne
