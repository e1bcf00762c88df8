#pragma once
/// The meaning of the names of columns.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/tables/table.hpp"

namespace ligne {

/// The columns of positions, heights and labels.
struct NamedColumns {
  std::optional<std::size_t> x, y, z, label;
};

/// "Elevation (m)", "elevation_m", "elevation [m]" become "elevation": small letters, without a unit.
std::string plain_name(std::string_view name);

/// Finds x, lon, easting ...; y, lat, northing ...; z, height, elevation ...; label, name, station ...: the
/// first of each. Where nothing else says x and y, columns named col and row do.
NamedColumns named_columns(const std::vector<std::string>& names);

/// A name for the numbers of rows or for their names: nothing, "index", "id", "rownames", "Unnamed: 0".
bool is_index_name(std::string_view name);

/// Names a position along an axis: "year", "time", "depth", and the names of x and y.
bool is_position_name(std::string_view name);

/// Names of columns that are positions: numbers, also with an X before them as R writes them, or months (1 to 12), ascending
/// or descending.
std::optional<std::vector<double>> positions_in_names(const std::vector<std::string>& names);

/// The number of a month by its English name or its first three letters.
std::optional<double> month_number(std::string_view name);

/// V1, V2, V3 ...: one word with ascending numbers behind it.
bool are_numbered(const std::vector<std::string>& names);

/// The column that is meant by a number from 1, as gnuplot counts, or by a name, whatever the case of its letters. Throws
/// InputError that lists the columns.
std::size_t column_of(const Table& table, const std::string& word, const std::string& name);

/// "elevation", or "3" where columns have no names.
std::string shown_column(const Table& table, std::size_t column);

}  // namespace ligne
