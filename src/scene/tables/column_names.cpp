#include "scene/tables/column_names.hpp"

#include <algorithm>
#include <array>

#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

constexpr std::array<std::string_view, 17> kX{"x",       "lon",      "long",    "longitude", "lng",     "east",
                                              "easting", "eastings", "utm_x",   "xutm",      "x_coord", "xcoord",
                                              "coord_x", "utm_e",    "point_x", "xpos",      "pos_x"};
constexpr std::array<std::string_view, 15> kY{"y",         "lat",   "latitude", "north",   "northing",
                                              "northings", "utm_y", "yutm",     "y_coord", "ycoord",
                                              "coord_y",   "utm_n", "point_y",  "ypos",    "pos_y"};
constexpr std::array<std::string_view, 20> kZ{
    "z",    "height",     "elevation",  "elev",   "value",   "alt",    "depth",   "dem",     "altitude",   "heights",
    "topo", "topography", "bathymetry", "zvalue", "z_coord", "zcoord", "coord_z", "point_z", "elevations", "values"};
constexpr std::array<std::string_view, 10> kLabels{"label", "name",  "station", "city", "town",
                                                   "place", "title", "text",    "site", "code"};
constexpr std::array<std::string_view, 18> kPositions{"year",  "month",    "day",        "time",        "hour",   "t",
                                                      "depth", "distance", "wavelength", "frequency",   "freq",   "level",
                                                      "date",  "nm",       "wavenumber", "wavelengths", "lambda", "energy"};
constexpr std::array<std::string_view, 10> kUnits{"m",       "km",     "ft",     "feet",  "deg",
                                                  "degrees", "metres", "meters", "metre", "meter"};
constexpr std::array<std::string_view, 12> kMonths{"january", "february", "march",     "april",   "may",      "june",
                                                   "july",    "august",   "september", "october", "november", "december"};

template <typename List>
bool is_one_of(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Whether the numbers ascend or descend throughout.
bool is_monotone(const std::vector<double>& at) {
  for (std::size_t i = 1; i < at.size(); ++i) {
    if (at[i] == at[i - 1] || (at[i] > at[i - 1]) != (at[1] > at[0])) return false;
  }
  return true;
}

/// Position at which the number at the end of a name begins.
std::size_t begin_of_digits(std::string_view name) {
  std::size_t begin = name.size();
  while (begin > 0 && name[begin - 1] >= '0' && name[begin - 1] <= '9') --begin;
  return begin;
}

}  // namespace

std::string plain_name(std::string_view name) {
  std::string plain = lower_case(trimmed(name));
  for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}}) {
    const std::size_t at = plain.find(open);
    if (at != std::string::npos && at > 0 && plain.back() == close) plain.resize(at);
  }
  plain = trimmed(plain);
  std::replace(plain.begin(), plain.end(), ' ', '_');
  std::replace(plain.begin(), plain.end(), '-', '_');
  std::replace(plain.begin(), plain.end(), '.', '_');
  const std::size_t unit = plain.rfind('_');
  if (unit != std::string::npos && unit > 0 && is_one_of(kUnits, std::string_view(plain).substr(unit + 1)))
    plain.resize(unit);
  return plain;
}

NamedColumns named_columns(const std::vector<std::string>& names) {
  NamedColumns found;
  std::optional<std::size_t> row, column;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string name = plain_name(names[k]);
    if (is_one_of(kX, name) && !found.x)
      found.x = k;
    else if (is_one_of(kY, name) && !found.y)
      found.y = k;
    else if (is_one_of(kZ, name) && !found.z)
      found.z = k;
    else if (is_one_of(kLabels, name) && !found.label)
      found.label = k;
    else if (name == "row" && !row)
      row = k;
    else if ((name == "col" || name == "column") && !column)
      column = k;
  }
  // Plots of a field are numbered by row and column.
  if (row && column && !found.x && !found.y) {
    found.x = column;
    found.y = row;
  }
  return found;
}

bool is_index_name(std::string_view name) {
  const std::string plain = plain_name(name);
  return plain.empty() || plain == "index" || plain == "id" || plain == "rownames" || plain == "row_names" ||
         plain == "fid" || plain.starts_with("unnamed");
}

bool is_position_name(std::string_view name) {
  const std::string plain = plain_name(name);
  return is_one_of(kPositions, plain) || is_one_of(kX, plain) || is_one_of(kY, plain);
}

std::optional<double> month_number(std::string_view name) {
  constexpr std::size_t kShort = 3;
  const std::string plain = plain_name(name);
  for (std::size_t k = 0; k < kMonths.size(); ++k) {
    if (plain == kMonths[k] || plain == kMonths[k].substr(0, kShort)) return static_cast<double>(k + 1);
  }
  return {};
}

std::optional<std::vector<double>> positions_in_names(const std::vector<std::string>& names) {
  std::vector<double> at;
  if (names.size() < 2) return {};
  for (const bool months : {false, true}) {
    at.clear();
    for (const std::string& name : names) {
      std::string_view word = trimmed(name);
      if (!months && word.size() > 1 && (word.front() == 'X' || word.front() == 'x')) word.remove_prefix(1);
      const std::optional<double> value = months ? month_number(word) : number_in(word);
      if (!value) break;
      at.push_back(*value);
    }
    if (at.size() == names.size() && is_monotone(at)) return at;
  }
  return {};
}

bool are_numbered(const std::vector<std::string>& names) {
  if (names.size() < 2) return false;
  const std::string_view first = names.front();
  const std::string_view word = first.substr(0, begin_of_digits(first));
  double before = -1;
  for (const std::string_view name : names) {
    const std::size_t begin = begin_of_digits(name);
    const std::optional<double> number = number_in(name.substr(begin));
    if (name.substr(0, begin) != word || !number || !(*number > before)) return false;
    before = *number;
  }
  return true;
}

std::size_t column_of(const Table& table, const std::string& word, const std::string& name) {
  for (std::size_t k = 0; k < table.names().size(); ++k) {
    if (equal_ignoring_case(table.names()[k], word)) return k;
  }
  const std::optional<std::int64_t> number = parse_integer(word);
  if (number && *number >= 1 && static_cast<std::uint64_t>(*number) <= table.columns())
    return static_cast<std::size_t>(*number - 1);
  std::string columns;
  for (std::size_t k = 0; k < table.names().size(); ++k) columns += (k == 0 ? "" : ", ") + printable(table.names()[k]);
  throw InputError(name, "has no column " + shown(word) + ": there are " +
                             (columns.empty() ? std::to_string(table.columns()) + ", numbered from 1" : columns));
}

std::string shown_column(const Table& table, std::size_t column) {
  const bool named = column < table.names().size() && !table.names()[column].empty();
  return named ? printable(table.names()[column]) : std::to_string(column + 1);
}

}  // namespace ligne
