#include "scene/height_filters.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace ligne {
namespace {

class LogHeights : public HeightSource {
 public:
  explicit LogHeights(std::unique_ptr<HeightSource> heights)
      : HeightSource(heights->x(), heights->y()), heights_(std::move(heights)) {}

  void read_row(std::size_t j, std::span<double> z) const override {
    heights_->read_row(j, z);
    for (double& height : z) height = height > 0 ? std::log10(height) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::unique_ptr<HeightSource> heights_;
};

/// Samples [begin, end) of an axis.
struct IndexRange {
  std::size_t begin, end;
};

IndexRange range_in(const std::vector<double>& positions, AxisWindow window) {
  const auto begin = std::lower_bound(positions.begin(), positions.end(), window.from);
  const auto end = std::upper_bound(begin, positions.end(), window.to);
  return {static_cast<std::size_t>(begin - positions.begin()), static_cast<std::size_t>(end - positions.begin())};
}

std::vector<double> part(const std::vector<double>& positions, IndexRange range) {
  return {positions.begin() + static_cast<std::ptrdiff_t>(range.begin), positions.begin() + static_cast<std::ptrdiff_t>(range.end)};
}

class WindowHeights : public HeightSource {
 public:
  WindowHeights(std::unique_ptr<HeightSource> heights, IndexRange x, IndexRange y)
      : HeightSource(part(heights->x(), x), part(heights->y(), y)), heights_(std::move(heights)), x_(x), y_(y) {}

  void read_row(std::size_t j, std::span<double> z) const override {
    std::vector<double> row(heights_->x().size());
    heights_->read_row(y_.begin + j, row);
    std::copy_n(row.begin() + static_cast<std::ptrdiff_t>(x_.begin), z.size(), z.begin());
  }

 private:
  std::unique_ptr<HeightSource> heights_;
  IndexRange x_, y_;
};

}  // namespace

std::unique_ptr<HeightSource> log_heights(std::unique_ptr<HeightSource> heights) {
  return std::make_unique<LogHeights>(std::move(heights));
}

std::unique_ptr<HeightSource> window_heights(std::unique_ptr<HeightSource> heights, AxisWindow x, AxisWindow y, const std::string& name) {
  const IndexRange columns = range_in(heights->x(), x), rows = range_in(heights->y(), y);
  const std::size_t width = columns.end - columns.begin, height = rows.end - rows.begin;
  if (width < 2 || height < 2) {
    throw InputError(name, "the window -x, -y holds " + std::to_string(width) + " columns and " + std::to_string(height) +
                               " rows of the grid; it takes two of each");
  }
  return std::make_unique<WindowHeights>(std::move(heights), columns, rows);
}

}  // namespace ligne
