#pragma once
/// Finds the meaning of column names.

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

/// Reduces "Elevation (m)", "elevation_m" and "elevation [m]" to "elevation": lower case, without a unit.
std::string plain_name(std::string_view name);

/// Finds the first of x, lon, easting ...; of y, lat, northing ...; of z, height, elevation ...; and of label, name,
/// station ... If nothing else gives x and y, columns named col and row do.
NamedColumns named_columns(const std::vector<std::string>& names);

/// Whether a name is that of row numbers or row names: empty, "index", "id", "rownames", "Unnamed: 0".
bool is_index_name(std::string_view name);

/// Whether a name is that of a position along an axis: "year", "time", "depth", and the names of x and y.
bool is_position_name(std::string_view name);

/// The positions in names of columns: ascending or descending numbers, also after an X as R writes them, or months (1
/// to 12).
std::optional<std::vector<double>> positions_in_names(const std::vector<std::string>& names);

/// The number of a month by its English name or its first three letters.
std::optional<double> month_number(std::string_view name);

/// Whether the names are one word with ascending numbers after it: V1, V2, V3 ...
bool are_numbered(const std::vector<std::string>& names);

/// The column given by a number from 1, as in gnuplot, or by a name in any case. Throws InputError with a list of the
/// columns.
std::size_t column_of(const Table& table, const std::string& word, const std::string& name);

/// A column in a message: "elevation", or "3" if columns have no names.
std::string shown_column(const Table& table, std::size_t column);

}  // namespace ligne
