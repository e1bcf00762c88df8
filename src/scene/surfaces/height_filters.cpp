#include "scene/surfaces/height_filters.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "base/parallel.hpp"
#include "geometry/degrees.hpp"
#include "scene/surfaces/held_heights.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {
namespace {

constexpr double kHole = std::numeric_limits<double>::quiet_NaN();

/// Reads all heights, row by row.
std::vector<double> all_heights(const HeightSource& heights) {
  const std::size_t columns = heights.x().size(), rows = heights.y().size();
  std::vector<double> z(columns * rows);
  parallel_for(rows, [&](std::size_t j) { heights.read_row(j, std::span(z).subspan(j * columns, columns)); });
  return z;
}

/// Another source with its heights changed, at the given positions.
template <class Change>
class ChangedHeights : public HeightSource {
 public:
  ChangedHeights(std::unique_ptr<HeightSource> heights, std::vector<double> x, std::vector<double> y, Change change)
      : HeightSource(std::move(x), std::move(y)), heights_(std::move(heights)), change_(std::move(change)) {}

  void read_row(std::size_t j, std::span<double> z) const override {
    heights_->read_row(j, z);
    std::ranges::transform(z, z.begin(), change_);
  }

 private:
  std::unique_ptr<HeightSource> heights_;
  Change change_;
};

/// Another source with its heights changed, at its own positions.
template <class Change>
std::unique_ptr<HeightSource> with_heights(std::unique_ptr<HeightSource> heights, Change change) {
  std::vector<double> x = heights->x(), y = heights->y();
  return std::make_unique<ChangedHeights<Change>>(std::move(heights), std::move(x), std::move(y), std::move(change));
}

/// Another source at other positions.
std::unique_ptr<HeightSource> moved_to(std::unique_ptr<HeightSource> heights, std::vector<double> x, std::vector<double> y) {
  return std::make_unique<ChangedHeights<std::identity>>(std::move(heights), std::move(x), std::move(y), std::identity{});
}

template <class Change>
std::vector<double> changed(std::vector<double> positions, bool is_changed, Change change) {
  if (is_changed) std::transform(positions.begin(), positions.end(), positions.begin(), change);
  return positions;
}

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
  return {positions.begin() + static_cast<std::ptrdiff_t>(range.begin),
          positions.begin() + static_cast<std::ptrdiff_t>(range.end)};
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

std::size_t kept_count(std::size_t n, std::size_t step) { return (n - 1 + step - 1) / step + 1; }

std::vector<double> at_places(const std::vector<double>& positions, const std::vector<std::size_t>& places) {
  std::vector<double> kept;
  kept.reserve(places.size());
  for (const std::size_t i : places) kept.push_back(positions[i]);
  return kept;
}

class ThinnedHeights : public HeightSource {
 public:
  ThinnedHeights(std::unique_ptr<HeightSource> whole, const std::vector<std::size_t>& columns, std::vector<std::size_t> rows)
      : HeightSource(at_places(whole->x(), columns), at_places(whole->y(), rows)),
        whole_(std::move(whole)),
        columns_(columns),
        rows_(std::move(rows)) {
    set_unit(whole_->unit());
  }

  void read_row(std::size_t j, std::span<double> z) const override {
    std::vector<double> row(whole_->x().size());
    whole_->read_row(rows_[j], row);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = row[columns_[i]];
  }

 private:
  std::unique_ptr<HeightSource> whole_;
  std::vector<std::size_t> columns_, rows_;
};

}  // namespace

std::unique_ptr<HeightSource> land_heights(std::unique_ptr<HeightSource> heights, double level) {
  return with_heights(std::move(heights), [level](double z) { return z > level ? z : kHole; });
}

bool level_noise(std::unique_ptr<HeightSource>& heights) {
  double low = INFINITY, high = -INFINITY;
  std::vector<double> row(heights->x().size());
  for (std::size_t j = 0; j < heights->y().size(); ++j) {
    heights->read_row(j, row);
    for (const double z : row) {
      if (z < low) low = z;
      if (z > high) high = z;
    }
    if (high - low > kFormulaRounding * std::max(std::abs(low), std::abs(high))) return false;
  }
  if (!(low < high)) return false;
  heights =
      with_heights(std::move(heights), [level = std::midpoint(low, high)](double z) { return std::isnan(z) ? z : level; });
  return true;
}

std::unique_ptr<HeightSource> log_heights(std::unique_ptr<HeightSource> heights) {
  return with_heights(std::move(heights), [](double z) { return z > 0 ? std::log10(z) : kHole; });
}

std::unique_ptr<HeightSource> log_ground(std::unique_ptr<HeightSource> heights, bool log_x, bool log_y,
                                         const std::string& name) {
  if (!log_x && !log_y) return heights;
  const AxisWindow positive{std::numeric_limits<double>::min(), std::numeric_limits<double>::infinity()};
  heights = window_heights(std::move(heights), log_x ? positive : AxisWindow{}, log_y ? positive : AxisWindow{}, name);
  const auto log = [](double at) { return std::log10(at); };
  std::vector<double> x = changed(heights->x(), log_x, log), y = changed(heights->y(), log_y, log);
  return moved_to(std::move(heights), std::move(x), std::move(y));
}

std::unique_ptr<HeightSource> scaled_ground(std::unique_ptr<HeightSource> heights, double factor_x, double factor_y) {
  if (factor_x == 1 && factor_y == 1) return heights;
  std::vector<double> x = changed(heights->x(), factor_x != 1, [&](double at) { return at * factor_x; });
  std::vector<double> y = changed(heights->y(), factor_y != 1, [&](double at) { return at * factor_y; });
  return moved_to(std::move(heights), std::move(x), std::move(y));
}

std::vector<char> steep_cells(const HeightSource& heights, double most, double units) {
  const std::vector<double>&x = heights.x(), &y = heights.y();
  const std::size_t columns = x.size(), width = columns - 1;
  std::vector<char> steep(width * (y.size() - 1), 0);
  parallel_for(y.size() - 1, [&](std::size_t j) {
    std::vector<double> low(columns), high(columns);
    heights.read_row(j, low);
    heights.read_row(j + 1, high);
    const auto shrunk = [&](double latitude) { return units > 1 ? sine_cosine_degrees(latitude).cosine : 1; };
    for (std::size_t i = 0; i < width; ++i) {
      const double across = (x[i + 1] - x[i]) * units * most, along = (y[j + 1] - y[j]) * units * most;
      steep[j * width + i] = std::abs(low[i + 1] - low[i]) > across * shrunk(y[j]) ||
                             std::abs(high[i + 1] - high[i]) > across * shrunk(y[j + 1]) ||
                             std::abs(high[i] - low[i]) > along || std::abs(high[i + 1] - low[i + 1]) > along;
    }
  });
  return steep;
}

std::unique_ptr<HeightSource> held(const HeightSource& heights) {
  return std::make_unique<HeldHeights<double>>(heights.x(), heights.y(), all_heights(heights),
                                               SampleOrder::first_row_lowest(heights.x().size()));
}

std::unique_ptr<HeightSource> transposed(const HeightSource& heights) {
  const SampleOrder order{0, static_cast<std::ptrdiff_t>(heights.x().size()), 1};
  return std::make_unique<HeldHeights<double>>(heights.y(), heights.x(), all_heights(heights), order);
}

AxesScaling ridgeline_scaling(const HeightSource& heights, double low, double high, double rows, double rows_height) {
  const std::vector<double>&x = heights.x(), &y = heights.y();
  AxesScaling scaling;
  scaling.factor.x = 1 / (x.back() - x.front());
  scaling.factor.y = rows_height / (y.back() - y.front());
  if (high > low) scaling.factor.z = rows * rows_height / static_cast<double>(y.size() - 1) / (high - low);
  scaling.origin = {x.front(), y.front(), low};
  return scaling;
}

std::unique_ptr<HeightSource> scaled_heights(std::unique_ptr<HeightSource> heights, const AxesScaling& scaling) {
  const auto scaled = [&](int axis) {
    return [origin = scaling.origin[axis], factor = scaling.factor[axis]](double at) { return (at - origin) * factor; };
  };
  std::vector<double> x = changed(heights->x(), true, scaled(0)), y = changed(heights->y(), true, scaled(1));
  return std::make_unique<ChangedHeights<decltype(scaled(2))>>(std::move(heights), std::move(x), std::move(y), scaled(2));
}

std::unique_ptr<HeightSource> window_heights(std::unique_ptr<HeightSource> heights, AxisWindow x, AxisWindow y,
                                             const std::string& name) {
  const IndexRange columns = range_in(heights->x(), x), rows = range_in(heights->y(), y);
  const std::size_t width = columns.end - columns.begin, height = rows.end - rows.begin;
  if (width < 2 || height < 2) {
    throw InputError(name, "the window -x, -y holds " + std::to_string(width) + " columns and " + std::to_string(height) +
                               " rows of the grid; two of each are needed");
  }
  return std::make_unique<WindowHeights>(std::move(heights), columns, rows);
}

std::size_t thinning_step(std::size_t columns, std::size_t rows, const GridChoice& choice) {
  if (!choice.may_thin || columns < 2 || rows < 2) return 1;
  std::size_t step = 1;
  while (kept_count(columns, step) > kMostGridSamples / kept_count(rows, step)) ++step;
  if (step == 1 || !choice.every) return step;
  // The step divides `every`, so that the requested curves keep their rows and columns.
  while (step < *choice.every && *choice.every % step != 0) ++step;
  return step <= *choice.every ? step : 1;
}

std::vector<std::size_t> kept_places(std::size_t n, std::size_t step) {
  std::vector<std::size_t> places;
  places.reserve(kept_count(n, step));
  for (std::size_t i = 0; i + 1 < n; i += step) places.push_back(i);
  places.push_back(n - 1);
  return places;
}

void warn_of_thinning(std::size_t columns, std::size_t rows, std::size_t step, Warnings& warnings) {
  warnings.add("grid of " + std::to_string(columns) + " x " + std::to_string(rows) + " samples thinned: 1 of " +
               std::to_string(step) + " rows and columns is drawn; -x and -y choose a part");
}

std::unique_ptr<HeightSource> thinned_heights(std::unique_ptr<HeightSource> heights, const GridChoice& choice,
                                              Warnings& warnings) {
  const std::size_t columns = heights->x().size(), rows = heights->y().size();
  const std::size_t step = heights->function() ? 1 : thinning_step(columns, rows, choice);
  if (step == 1) return heights;
  warn_of_thinning(columns, rows, step, warnings);
  auto thinned = std::make_unique<ThinnedHeights>(std::move(heights), kept_places(columns, step), kept_places(rows, step));
  thinned->set_thinned_by(step);
  return thinned;
}

}  // namespace ligne
