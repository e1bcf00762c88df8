// Rows that begin with their position, such as a wavelength before the intensities of several spectra.

#include <algorithm>
#include <cmath>

#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// Smallest number of rows that have even steps not just by chance.
constexpr std::size_t kFewestEvenRows = 8;
/// Largest deviation of a position from an even series, in steps: positions are written with few digits.
constexpr double kEvenStep = 0.02;
/// Smallest difference between positions and the column beside them, relative to the differences between columns of
/// heights. Measured: 13,000 for spectra of 400 wavelengths, 0.4 and 0.6 for two grids of terrain.
constexpr double kApart = 4;

/// Mean difference between a column and the next one, over the rows with a number in both.
double difference_from_next(std::span<const double> values, std::size_t columns, std::size_t column) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = column; k + 1 < values.size(); k += columns) {
    const double difference = std::abs(values[k] - values[k + 1]);
    if (!std::isfinite(difference)) continue;
    sum += difference;
    ++count;
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

}  // namespace

bool has_even_steps(std::span<const double> values, std::size_t columns, std::size_t column) {
  const std::size_t rows = columns == 0 ? 0 : values.size() / columns;
  if (rows < kFewestEvenRows) return false;
  const double first = values[column], last = values[(rows - 1) * columns + column];
  const double step = (last - first) / static_cast<double>(rows - 1);
  if (!(std::abs(step) > 0)) return false;
  for (std::size_t row = 0; row < rows; ++row) {
    const double place = first + static_cast<double>(row) * step;
    if (!(std::abs(values[row * columns + column] - place) <= kEvenStep * std::abs(step))) return false;
  }
  return true;
}

FirstColumn kind_of_first_column(std::span<const double> values, std::size_t columns) {
  if (columns < 3 || !has_even_steps(values, columns, 0)) return FirstColumn::heights;
  double most = 0;
  for (std::size_t k = 1; k < columns; ++k) {
    if (has_even_steps(values, columns, k)) return FirstColumn::heights;
    if (k + 1 < columns) most = std::max(most, difference_from_next(values, columns, k));
  }
  return difference_from_next(values, columns, 0) >= kApart * most ? FirstColumn::positions : FirstColumn::doubtful;
}

std::unique_ptr<HeightSource> series_of_rows(std::span<const double> values, std::size_t columns, const std::string& name,
                                             Warnings& warnings) {
  std::vector<double> y, z;
  for (std::size_t k = 0; k < values.size(); ++k) (k % columns == 0 ? y : z).push_back(values[k]);
  if (y.size() > 1 && direction_of(y) == 0) return nullptr;
  drop_missing_values(z, 1, warnings);
  return heights_over(counted_positions(columns - 1), std::move(y), std::move(z), name);
}

}  // namespace ligne
