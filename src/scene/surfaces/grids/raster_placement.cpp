#include "scene/surfaces/grids/raster_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <system_error>

#include <glm/geometric.hpp>

#include "files/message_text.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// Largest deviation of a direction that counts as parallel to an axis, relative to its length: a millionth of a pixel
/// in a raster of a thousand pixels.
constexpr double kAlongAxis = 1e-9;

/// Largest size of a world file in bytes: six numbers of 24 characters, with ample room for blanks and comments.
constexpr std::uintmax_t kLargestWorldFile = 4096;

bool runs_along(Point2 direction, int axis) {
  return std::abs(direction[1 - axis]) <= kAlongAxis * std::abs(direction[axis]);
}

/// n positions.
std::vector<double> steps(double place, double pixel, double sample_at, double step, std::size_t n) {
  std::vector<double> at(n);
  for (std::size_t i = 0; i < n; ++i) at[i] = place + (static_cast<double>(i) + sample_at - pixel) * step;
  return at;
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      const std::optional<double> number = number_in(word);
      if (!number) return std::nullopt;
      numbers.push_back(*number);
    }
  }
  return numbers;
}

}  // namespace

bool RasterTransform::is_finite() const {
  return std::isfinite(pixel.x + pixel.y + at.x + at.y + per_column.x + per_column.y + per_row.x + per_row.y);
}

std::optional<RasterPlacement> place_raster(const RasterTransform& transform, std::size_t columns, std::size_t rows) {
  const Point2 right = transform.per_column, down = transform.per_row;
  const double across = right.x * down.y - right.y * down.x, lengths = glm::length(right) * glm::length(down);
  if (!transform.is_finite() || !(std::abs(across) > kAlongAxis * lengths)) return std::nullopt;
  // The axis along which columns advance, and the axis of the rows.
  const int column_axis = std::abs(right.x) * std::abs(down.y) >= std::abs(right.y) * std::abs(down.x) ? 0 : 1;
  const int row_axis = 1 - column_axis;
  RasterPlacement placed;
  std::vector<double>& of_columns = column_axis == 0 ? placed.x : placed.y;
  std::vector<double>& of_rows = column_axis == 0 ? placed.y : placed.x;
  double column_step = right[column_axis], row_step = down[row_axis];
  Point2 at = transform.at, pixel = transform.pixel;
  if (!runs_along(right, column_axis) || !runs_along(down, row_axis)) {
    const Point2 middle = Point2(static_cast<double>(columns), static_cast<double>(rows)) * 0.5;
    at += right * (middle.x - pixel.x) + down * (middle.y - pixel.y);
    pixel = middle;
    column_step = std::copysign(glm::length(right), column_step);
    row_step = std::copysign(glm::length(down), row_step);
    const Point2 along = right * std::copysign(1.0, column_step);
    placed.turned_degrees = std::atan2(along[row_axis], along[column_axis]) * 180 / std::numbers::pi;
    if (column_axis == 1) placed.turned_degrees = -placed.turned_degrees;
    placed.sheared = std::abs(glm::dot(right, down)) > kAlongAxis * lengths;
  }
  of_columns = steps(at[column_axis], pixel.x, transform.sample_at, column_step, columns);
  of_rows = steps(at[row_axis], pixel.y, transform.sample_at, row_step, rows);
  const auto step_along = [](int axis) { return axis == 0 ? &SampleOrder::step_x : &SampleOrder::step_y; };
  placed.order.begin = 0;
  placed.order.*step_along(column_axis) = 1;
  placed.order.*step_along(row_axis) = static_cast<std::ptrdiff_t>(columns);
  if (column_step < 0) placed.order.turn(of_columns, step_along(column_axis));
  if (row_step < 0) placed.order.turn(of_rows, step_along(row_axis));
  return placed;
}

RasterPlacement count_raster(std::size_t columns, std::size_t rows) {
  return {counted_positions(columns), counted_positions(rows), SampleOrder::first_row_highest(columns, rows)};
}

void warn_of_turned_raster(const RasterPlacement& placement, Warnings& warnings) {
  if (placement.turned_degrees == 0 && !placement.sheared) return;
  const std::string how = placement.sheared ? "sheared" : "turned by " + rounded(placement.turned_degrees) + " degrees";
  warnings.add("raster " + how + " against x and y: drawn along its own rows and columns; gdalwarp can rotate it");
}

std::optional<RasterTransform> read_world_file(const std::filesystem::path& picture, InputFiles& opened,
                                               Warnings& warnings) {
  if (picture.empty()) return std::nullopt;
  std::array<std::filesystem::path, 5> candidates;
  candidates.fill(picture);
  candidates[0].replace_extension(".tfw");
  candidates[1].replace_extension(".TFW");
  candidates[2] += "w";
  candidates[3].replace_extension(".wld");
  candidates[4].replace_extension(".WLD");
  const auto is_file = [](const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored);
  };
  const auto found = std::find_if(candidates.begin(), candidates.end(), is_file);
  if (found == candidates.end()) return std::nullopt;
  const std::string name = printable(found->string(), kLongestPath);
  const std::vector<std::byte> bytes = read_input(*found, name, opened, kLargestWorldFile);
  const auto numbers = numbers_in(as_characters(bytes));
  if (!numbers || numbers->size() != 6) {
    warnings.add("world file without six numbers, " + name + ": rows and columns used as positions");
    return std::nullopt;
  }
  const std::vector<double>& n = *numbers;
  return RasterTransform{.at = {n[4], n[5]}, .per_column = {n[0], n[1]}, .per_row = {n[2], n[3]}, .sample_at = 0};
}

}  // namespace ligne
