// Grids of Golden Software's Surfer: DSAA as text, DSBB of version 6, DSRB of version 7. Rows run upwards from the
// lowest y.

#include <bit>
#include <cmath>
#include <cstdint>

#include "scene/readers/load_bytes.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// Surfer marks a missing height by 1.70141e38, written with more or fewer digits.
constexpr double kSurferBlank = 1.7014e38;

double surfer_height(double value) { return value >= kSurferBlank || !std::isfinite(value) ? kNoHeight : value; }

std::vector<double> from_to(double from, double to, std::size_t count) {
  std::vector<double> at(count);
  for (std::size_t i = 0; i < count; ++i)
    at[i] = i + 1 == count ? to : from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
  return at;
}

std::unique_ptr<HeightSource> surfer_heights(std::vector<double> x, std::vector<double> y, std::vector<double> z,
                                             const std::string& name) {
  const SampleOrder order = SampleOrder::first_row_lowest(x.size());
  return held_heights(std::move(x), std::move(y), std::move(z), order, name);
}

/// Reads consecutive numbers of a file.
class SurferBytes {
 public:
  SurferBytes(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  template <typename Number>
  Number take() {
    if (bytes_.size() < sizeof(Number)) throw InputError(name_, "Surfer grid: ends early");
    const auto value = load_bytes<Number>(bytes_.data(), std::endian::little);
    bytes_ = bytes_.subspan(sizeof(Number));
    return value;
  }
  /// Reads the number of columns or of rows.
  template <typename Number>
  std::size_t take_count() {
    const auto count = take<Number>();
    if (count < 0) throw InputError(name_, "Surfer grid: a number of cells is below zero");
    return static_cast<std::size_t>(count);
  }
  template <typename Number>
  std::vector<double> take_heights(std::size_t columns, std::size_t rows) {
    check_counts(columns, rows, name_);
    if (rows > bytes_.size() / sizeof(Number) / columns) {
      throw InputError(name_, "is truncated: " + std::to_string(columns) + " x " + std::to_string(rows) +
                                  " heights do not fit into " + std::to_string(bytes_.size()) + " bytes");
    }
    std::vector<double> heights(columns * rows);
    for (double& height : heights) height = take<Number>();
    return heights;
  }
  void skip(std::size_t count) { bytes_ = bytes_.subspan(std::min(count, bytes_.size())); }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  const std::string& name_;
};

std::unique_ptr<HeightSource> read_dsbb(SurferBytes bytes, const std::string& name) {
  const std::size_t columns = bytes.take_count<std::int16_t>(), rows = bytes.take_count<std::int16_t>();
  double range[6];
  for (double& limit : range) limit = bytes.take<double>();
  std::vector<double> z = bytes.take_heights<float>(columns, rows);
  for (double& height : z) height = surfer_height(height);
  return surfer_heights(from_to(range[0], range[1], columns), from_to(range[2], range[3], rows), std::move(z), name);
}

/// Reads sections of a tag, a length and data. The section that describes the grid precedes the heights.
std::unique_ptr<HeightSource> read_dsrb(SurferBytes bytes, const std::string& name, Warnings& warnings) {
  constexpr std::uint32_t kGridTag = 0x44495247, kDataTag = 0x41544144, kFaultTag = 0x49544c46;
  bytes.skip(bytes.take<std::uint32_t>());  // the header's data: the version
  std::size_t columns = 0, rows = 0;
  double low_x = 0, low_y = 0, step_x = 0, step_y = 0, blank = kSurferBlank;
  std::vector<double> z;
  while (bytes.left() >= 2 * sizeof(std::uint32_t)) {
    const auto tag = bytes.take<std::uint32_t>();
    const auto length = bytes.take<std::uint32_t>();
    const std::size_t left = bytes.left();
    if (tag == kGridTag) {
      rows = bytes.take_count<std::int32_t>();
      columns = bytes.take_count<std::int32_t>();
      low_x = bytes.take<double>();
      low_y = bytes.take<double>();
      step_x = bytes.take<double>();
      step_y = bytes.take<double>();
      bytes.skip(2 * sizeof(double));  // the range of heights
      if (bytes.take<double>() != 0) warnings.leave_out("rotation of the grid");
      blank = bytes.take<double>();
    } else if (tag == kDataTag && z.empty()) {
      if (columns == 0) throw InputError(name, "Surfer grid: heights precede their description");
      z = bytes.take_heights<double>(columns, rows);
    } else if (tag == kFaultTag) {
      warnings.leave_out("fault lines");
    }
    const std::size_t taken = left - bytes.left();
    if (length > taken) bytes.skip(length - taken);
  }
  if (z.empty()) throw InputError(name, "Surfer grid: holds no heights");
  for (double& height : z) height = height >= blank ? kNoHeight : surfer_height(height);
  const auto last = [](double low, double step, std::size_t count) { return low + step * static_cast<double>(count - 1); };
  return surfer_heights(from_to(low_x, last(low_x, step_x, columns), columns),
                        from_to(low_y, last(low_y, step_y, rows), rows), std::move(z), name);
}

std::unique_ptr<HeightSource> read_dsaa(std::string_view text, const std::string& name) {
  constexpr std::size_t kHead = 8;  // columns, rows, and the ranges of x, y and z
  LineReader lines(text);
  std::string_view line;
  lines.next(line);
  std::vector<double> head, z;
  std::size_t columns = 0, rows = 0;
  while (lines.next(line)) {
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      const std::optional<double> value = number_in(word);
      if (!value) throw error_at_line(name, lines.number(), shown(word) + " is not a number");
      if (head.size() == kHead) {
        if (z.size() == columns * rows)
          throw error_at_line(name, lines.number(), "more heights than the " + std::to_string(z.size()) + " of the header");
        z.push_back(surfer_height(*value));
        continue;
      }
      head.push_back(*value);
      if (head.size() != 2) continue;
      // Every height takes at least a character and a separator.
      for (const double count : head) {
        if (!(count >= 1 && count == std::floor(count) && count <= static_cast<double>(text.size())))
          throw error_at_line(name, lines.number(),
                              shown(word) + " is not a number of cells, or more than the file can hold");
      }
      columns = static_cast<std::size_t>(head[0]);
      rows = static_cast<std::size_t>(head[1]);
      check_counts(columns, rows, name);
      if (rows > text.size() / 2 / columns + 1)
        throw InputError(name,
                         "header declares more heights than a file of " + std::to_string(text.size()) + " bytes can hold");
    }
  }
  if (head.size() < kHead || z.size() != columns * rows)
    throw InputError(name, "ends after " + std::to_string(z.size()) + " of " + std::to_string(columns * rows) + " heights");
  return surfer_heights(from_to(head[2], head[3], columns), from_to(head[4], head[5], rows), std::move(z), name);
}

}  // namespace

bool is_surfer_grid(std::string_view bytes) {
  const bool is_text =
      bytes.starts_with("DSAA") && bytes.size() > 4 && (is_blank(bytes[4]) || bytes[4] == '\n' || bytes[4] == '\r');
  return is_text || bytes.starts_with("DSBB") || bytes.starts_with("DSRB");
}

std::unique_ptr<HeightSource> read_surfer_grid(std::span<const std::byte> bytes, const std::string& name,
                                               Warnings& warnings) {
  const std::string_view chars(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  constexpr std::size_t kMark = 4;
  if (chars.starts_with("DSAA")) return read_dsaa(as_text(bytes, name), name);
  const SurferBytes behind(bytes.subspan(kMark), name);
  return chars.starts_with("DSBB") ? read_dsbb(behind, name) : read_dsrb(behind, name, warnings);
}

}  // namespace ligne
