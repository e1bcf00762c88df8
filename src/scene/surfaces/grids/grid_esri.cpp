// Lines "key value", then the heights row by row, starting in the north-west. Rows may be broken into lines anywhere.
// GRASS writes "rows: 20" and the four sides "north: 5000" instead.

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// The value for a missing height in files that do not define one.
constexpr double kNoDataByDefault = -9999;

/// Larger values are missing heights: some writers print the largest number of single precision for them, with more or
/// fewer digits than NODATA_value has.
constexpr double kBeyondEsriHeights = 1e30;

/// Whether a value equals NODATA as a double, or in single precision, in which most writers hold heights.
bool is_no_data(double value, double no_data) {
  if (value == no_data) return true;
  if (std::abs(no_data) >= kBeyondEsriHeights) return std::abs(value) >= kBeyondEsriHeights && (value > 0) == (no_data > 0);
  return std::abs(value) < kBeyondEsriHeights && static_cast<float>(value) == static_cast<float>(no_data);
}

struct Header {
  std::optional<std::int64_t> columns, rows;
  std::optional<double> x_corner, y_corner, x_center, y_center, dx, dy, no_data, north, east;

  /// Derives the size of cells from the sides that GRASS writes.
  void take_sides() {
    if (north && y_corner && rows) dy = (*north - *y_corner) / static_cast<double>(*rows);
    if (east && x_corner && columns) dx = (*east - *x_corner) / static_cast<double>(*columns);
  }
};

constexpr std::string_view kKeys[] = {"ncols", "cols:", "nrows", "rows:", "cellsize", "dx", "dy", "type:"};

/// Keys with a number of any size.
constexpr std::pair<std::string_view, std::optional<double> Header::*> kValues[] = {
    {"xllcorner", &Header::x_corner}, {"west:", &Header::x_corner},       {"yllcorner", &Header::y_corner},
    {"south:", &Header::y_corner},    {"xllcenter", &Header::x_center},   {"yllcenter", &Header::y_center},
    {"north:", &Header::north},       {"east:", &Header::east},           {"null:", &Header::no_data},
    {"nodata", &Header::no_data},     {"nodata_value", &Header::no_data},
};

bool is_key(std::string_view word) {
  return std::ranges::any_of(kKeys, [&](std::string_view key) { return equal_ignoring_case(word, key); }) ||
         std::ranges::any_of(kValues, [&](const auto& key) { return equal_ignoring_case(word, key.first); });
}

class EsriReader {
 public:
  EsriReader(std::string_view text, const std::string& name, Warnings& warnings)
      : text_size_(text.size()), lines_(text), name_(name), warnings_(warnings) {}

  std::unique_ptr<HeightSource> read() {
    std::string_view line;
    bool has_line = lines_.next(line);
    for (; has_line && read_header_line(line); has_line = lines_.next(line)) {
    }
    check_header();
    for (; has_line; has_line = lines_.next(line)) read_heights(line);
    if (heights_.size() != wanted_) {
      throw error("ends after " + std::to_string(heights_.size()) + " of " + std::to_string(wanted_) + " heights" +
                  uneven_row_);
    }
    std::vector<double> x = positions(header_.x_corner, header_.x_center, *header_.dx, columns_);
    std::vector<double> y = positions(header_.y_corner, header_.y_center, *header_.dy, rows_);
    return held_heights(std::move(x), std::move(y), std::move(heights_), SampleOrder::first_row_highest(columns_, rows_),
                        name_);
  }

 private:
  InputError error(const std::string& cause) const { return error_at_line(name_, lines_.number(), cause); }

  /// Returns false if the line holds heights.
  bool read_header_line(std::string_view line) {
    const std::string_view key = take_word(line);
    if (key.empty()) return true;
    if (!is_key(key)) {
      if (height_in(key)) return false;
      throw error("unknown key " + shown(key) + " in the header");
    }
    const std::string_view word = take_word(line);
    if (word.empty() || !trimmed(line).empty()) throw error("key " + shown(key) + " needs one value");
    const auto is = [&](std::string_view name) { return equal_ignoring_case(key, name); };
    if (is("ncols") || is("cols:")) header_.columns = count_in(key, word);
    if (is("nrows") || is("rows:")) header_.rows = count_in(key, word);
    if (is("dx") || is("cellsize")) header_.dx = size_in(key, word);
    if (is("dy") || is("cellsize")) header_.dy = size_in(key, word);
    for (const auto& [name, value] : kValues) {
      if (is(name)) header_.*value = value_in(key, word, value == &Header::no_data);
    }
    return true;
  }

  std::int64_t count_in(std::string_view key, std::string_view word) const {
    const std::optional<std::int64_t> value = parse_integer(word);
    if (!value || *value < 1) throw error(printable(key) + " " + shown(word) + " is not a number of cells");
    // Every height takes at least a character and a separator.
    const std::size_t most = text_size_ / 2 + 1;
    if (static_cast<std::uint64_t>(*value) > most) {
      throw error(printable(key) + " " + shown(word) + " is more than a file of " + std::to_string(text_size_) +
                  " bytes can hold");
    }
    return *value;
  }

  double value_in(std::string_view key, std::string_view word, bool may_be_missing = false) const {
    const std::optional<double> value = may_be_missing ? height_in(word) : number_in(word);
    if (!value) throw error(printable(key) + " " + shown(word) + " is not a number");
    return *value;
  }

  double size_in(std::string_view key, std::string_view word) const {
    const double value = value_in(key, word);
    if (!(value > 0)) throw error(printable(key) + " " + shown(word) + " is not above zero");
    return value;
  }

  void check_header() {
    header_.take_sides();
    const auto need = [&](bool holds, const std::string& what) {
      if (!holds) throw InputError(name_, "the header of the ESRI ASCII grid lacks " + what);
    };
    need(header_.columns.has_value(), "ncols");
    need(header_.rows.has_value(), "nrows");
    need(header_.dx && header_.dy && *header_.dx > 0 && *header_.dy > 0, "cellsize");
    need(header_.x_corner || header_.x_center, "xllcorner");
    need(header_.y_corner || header_.y_center, "yllcorner");
    columns_ = static_cast<std::size_t>(*header_.columns);
    rows_ = static_cast<std::size_t>(*header_.rows);
    check_counts(columns_, rows_, name_);
    // Both counts are below the size of the file, so their product can not overflow.
    wanted_ = columns_ * rows_;
    if (wanted_ > text_size_ / 2 + 1) {
      throw InputError(name_, "header declares " + std::to_string(wanted_) + " heights, more than a file of " +
                                  std::to_string(text_size_) + " bytes can hold");
    }
    heights_.reserve(wanted_);
  }

  void read_heights(std::string_view line) {
    const double no_data = header_.no_data.value_or(kNoDataByDefault);
    const std::size_t before = heights_.size();
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      const std::optional<double> value = height_in(word);
      // Some programs write the projection behind the heights.
      if (!value && heights_.size() == wanted_) return warnings_.leave_out("lines behind the heights", 1);
      if (!value) throw error(shown(word) + " is not a number");
      if (heights_.size() == wanted_)
        throw error("more heights than the " + std::to_string(wanted_) + " of the header" + uneven_row_);
      heights_.push_back(is_no_data(*value, no_data) ? kNoHeight : *value);
    }
    const std::size_t count = heights_.size() - before;
    if (count != 0 && count != columns_ && uneven_row_.empty()) {
      uneven_row_ = "; line " + std::to_string(lines_.number()) + " has " + std::to_string(count) + ", ncols is " +
                    std::to_string(columns_);
    }
  }

  /// Positions of the centres of the cells; a corner lies half a cell before the first centre.
  static std::vector<double> positions(std::optional<double> corner, std::optional<double> center, double step,
                                       std::size_t n) {
    std::vector<double> out(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<double>(i);
      out[i] = center ? *center + k * step : *corner + (k + 0.5) * step;
    }
    return out;
  }

  std::size_t text_size_;
  LineReader lines_;
  const std::string& name_;
  Warnings& warnings_;
  Header header_;
  std::size_t columns_ = 0, rows_ = 0, wanted_ = 0;
  std::vector<double> heights_;  ///< from north to south
  std::string uneven_row_;       ///< place of the first line that is not a whole row, for error messages
};

}  // namespace

bool is_esri_grid(std::string_view text) {
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    const std::string_view key = take_word(line);
    if (!key.empty()) return is_key(key) && !take_word(line).empty();
  }
  return false;
}

std::unique_ptr<HeightSource> read_esri_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings) {
  std::string_view text = as_text(bytes, name);
  std::string with_points;
  if (text.find(',') != std::string_view::npos) {  // decimal commas
    std::ranges::replace_copy(text, std::back_inserter(with_points), ',', '.');
    text = with_points;
  }
  return EsriReader(text, name, warnings).read();
}

}  // namespace ligne
