#include "picture/surface/undersampled.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ligne {
namespace {

/// Number of rows of cells, and of cells of each, that are looked at. With the samples of two rows they cost less than two
/// hundredths of a surface of 200 x 200 samples.
constexpr std::size_t kRows = 16, kCellsOfRow = 16;
/// Smallest number of cells with heights that tells anything.
constexpr std::size_t kFewestCells = 32;
/// Trimmed part of the heights at each end: their range without peaks and poles.
constexpr double kTrimmed = 0.1;
/// A difference is gross above this part of the trimmed range, and the surface is undersampled if this part of the cells
/// has gross differences. Taste: sines of less than eight samples in a period are undersampled.
constexpr double kGross = 1. / 16, kLargePart = 1. / 3;

/// The k-th of `count` places among `size`, spread evenly but not regularly, so that a periodic surface can not hide.
std::size_t spread(std::size_t k, std::size_t count, std::size_t size, std::size_t shift) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  const double turns = static_cast<double>(k + shift * count) * kGoldenRatio;
  const double at = (static_cast<double>(k) + turns - std::floor(turns)) / static_cast<double>(count);
  return std::min(size - 1, static_cast<std::size_t>(at * static_cast<double>(size)));
}

struct Differences {
  std::vector<double> heights, differences;
};

/// Adds the cells between the rows j and j + 1; on row j only if the picture does not interpolate between rows.
void add_row(const HeightSource& heights, HeightFunction::At& at, InterpolatedAxes axes, std::size_t j, Differences& out) {
  const std::vector<double>&x = heights.x(), &y = heights.y();
  const std::size_t next = axes.y ? j + 1 : j, cells = std::min(kCellsOfRow, x.size() - 1);
  std::vector<double> low(x.size()), high(x.size());
  heights.read_row(j, low);
  heights.read_row(next, high);
  for (std::size_t k = 0; k < cells; ++k) {
    const std::size_t i = spread(k, cells, x.size() - 1, j), i_next = axes.x ? i + 1 : i;
    const double between = (low[i] + low[i_next] + high[i] + high[i_next]) / 4;
    const double z = at((x[i] + x[i_next]) / 2, (y[j] + y[next]) / 2);
    if (!std::isfinite(between) || !std::isfinite(z)) continue;
    out.heights.push_back(z);
    out.differences.push_back(std::abs(z - between));
  }
}

}  // namespace

bool is_undersampled(const HeightSource& heights, const HeightFunction& function, InterpolatedAxes axes) {
  Differences found;
  function.use([&](HeightFunction::At& at) {
    const std::size_t rows = heights.y().size() - 1, chosen = std::min(kRows, rows);
    for (std::size_t k = 0; k < chosen; ++k) add_row(heights, at, axes, spread(k, chosen, rows, 0), found);
  });
  const std::size_t n = found.heights.size();
  if (n < kFewestCells) return false;
  std::ranges::sort(found.heights);
  const auto trimmed = static_cast<std::size_t>(kTrimmed * static_cast<double>(n));
  const double range = found.heights[n - 1 - trimmed] - found.heights[trimmed];
  const auto gross = std::ranges::count_if(found.differences, [&](double d) { return d > kGross * range; });
  return range > 0 && static_cast<double>(gross) > kLargePart * static_cast<double>(n);
}

}  // namespace ligne
