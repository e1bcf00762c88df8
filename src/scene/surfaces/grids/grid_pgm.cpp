// "P2" or "P5", then width, height and the largest value as text with comments; then the values, as text or as one or
// two bytes each (high byte first).

#include <algorithm>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/height_filters.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

constexpr std::int64_t kLargestValue = 65535;

constexpr bool is_space(char c) { return is_blank(c) || c == '\n' || c == '\r'; }

class PgmReader {
 public:
  PgmReader(std::string_view chars, const std::string& name) : chars_(chars), name_(name) {}

  std::unique_ptr<HeightSource> read(Warnings& warnings, const GridChoice& choice) {
    const bool is_text = chars_[1] == '2';
    at_ = 2;
    // There can not be more values than bytes.
    const auto most = static_cast<std::int64_t>(chars_.size());
    const auto columns = static_cast<std::size_t>(take_number("width", 1, most));
    const auto rows = static_cast<std::size_t>(take_number("height", 1, most));
    largest_ = take_number("largest value", 1, kLargestValue);
    check_counts(columns, rows, name_);
    const std::size_t bytes_each = is_text ? 2 : largest_ < 256 ? 1 : 2;
    if (!is_text) ++at_;  // skips the single white space after the header
    const std::size_t left = chars_.size() - std::min(at_, chars_.size());
    // The last value of a text needs no separator.
    if (rows > (left + (is_text ? 1 : 0)) / bytes_each / columns) {
      throw InputError(name_, "is truncated: " + std::to_string(columns) + " x " + std::to_string(rows) +
                                  " values do not fit into " + std::to_string(left) + " bytes");
    }
    const std::size_t step = thinning_step(columns, rows, choice);
    if (step > 1) warn_of_thinning(columns, rows, step, warnings);
    const std::vector<std::size_t> kept_x = kept_places(columns, step), kept_y = kept_places(rows, step);
    std::vector<std::uint16_t> row(columns), values;
    values.reserve(kept_x.size() * kept_y.size());
    for (std::size_t j = rows, kept = kept_y.size(); j-- > 0;) {
      for (std::uint16_t& value : row) value = is_text ? text_value() : binary_value(bytes_each);
      if (kept == 0 || kept_y[kept - 1] != j) continue;
      --kept;
      for (const std::size_t i : kept_x) values.push_back(row[i]);
    }
    if (!is_text && at_ < chars_.size()) warnings.add("pictures or bytes after the first picture omitted");
    auto heights =
        held_heights(std::vector<double>(kept_x.begin(), kept_x.end()), std::vector<double>(kept_y.begin(), kept_y.end()),
                     std::move(values), SampleOrder::first_row_highest(kept_x.size(), kept_y.size()), name_);
    heights->set_thinned_by(step);
    return heights;
  }

 private:
  InputError error(const std::string& cause) const {
    const std::string_view before = chars_.substr(0, at_);
    return error_at_line(name_, 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')), cause);
  }

  std::string_view take_token() {
    while (at_ < chars_.size() && (is_space(chars_[at_]) || chars_[at_] == '#')) {
      if (chars_[at_] == '#')
        at_ = std::min(chars_.find_first_of("\r\n", at_), chars_.size());
      else
        ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < chars_.size() && !is_space(chars_[at_]) && chars_[at_] != '#') ++at_;
    return chars_.substr(begin, at_ - begin);
  }

  std::int64_t take_number(const std::string& what, std::int64_t least, std::int64_t most) {
    const std::string_view token = take_token();
    if (token.empty()) throw error("is truncated before the " + what);
    const std::optional<std::int64_t> value = parse_integer(token);
    if (!value) throw error(what + " " + shown(token) + " is not a whole number");
    if (*value < least || *value > most) {
      throw error(what + " " + printable(token) + " is not between " + std::to_string(least) + " and " +
                  std::to_string(most));
    }
    return *value;
  }

  std::uint16_t text_value() { return static_cast<std::uint16_t>(take_number("value", 0, largest_)); }

  std::uint16_t binary_value(std::size_t bytes_each) {
    unsigned value = 0;
    for (std::size_t k = 0; k < bytes_each; ++k) value = value << 8 | static_cast<unsigned char>(chars_[at_++]);
    if (value > largest_) {
      throw InputError(
          name_, "value " + std::to_string(value) + " is above the largest of the header, " + std::to_string(largest_));
    }
    return static_cast<std::uint16_t>(value);
  }

  std::string_view chars_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::int64_t largest_ = 0;
};

}  // namespace

std::unique_ptr<HeightSource> read_pgm_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                            const GridChoice& choice) {
  return PgmReader({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name).read(warnings, choice);
}

}  // namespace ligne
