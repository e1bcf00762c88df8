#pragma once
/// Heights held in memory, in the order and with the type of the file.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// Position of the height at x[i], y[j]: samples[begin + i * step_x + j * step_y].
struct SampleOrder {
  std::ptrdiff_t begin = 0, step_x = 1, step_y = 0;

  /// Consecutive rows, of which the first one has the smallest y, or the largest.
  static SampleOrder first_row_lowest(std::size_t columns) { return {0, 1, static_cast<std::ptrdiff_t>(columns)}; }
  static SampleOrder first_row_highest(std::size_t columns, std::size_t rows) {
    const auto step = static_cast<std::ptrdiff_t>(columns);
    return {(static_cast<std::ptrdiff_t>(rows) - 1) * step, 1, -step};
  }
  /// Reverses the positions along an axis, of which `step` is the step.
  void turn(std::vector<double>& positions, std::ptrdiff_t SampleOrder::*step) {
    std::reverse(positions.begin(), positions.end());
    begin += (static_cast<std::ptrdiff_t>(positions.size()) - 1) * this->*step;
    this->*step = -(this->*step);
  }
};

template <typename Sample>
class HeldHeights : public HeightSource {
 public:
  HeldHeights(std::vector<double> x, std::vector<double> y, std::vector<Sample> samples, SampleOrder order)
      : HeightSource(std::move(x), std::move(y)), samples_(std::move(samples)), order_(order) {}

  void read_row(std::size_t j, std::span<double> z) const override {
    std::ptrdiff_t at = order_.begin + static_cast<std::ptrdiff_t>(j) * order_.step_y;
    if (order_.step_x == 1) {
      std::copy_n(samples_.begin() + at, z.size(), z.begin());
      return;
    }
    for (double& height : z) {
      height = static_cast<double>(samples_[static_cast<std::size_t>(at)]);
      at += order_.step_x;
    }
  }

 private:
  std::vector<Sample> samples_;
  SampleOrder order_;
};

/// The positions 0, 1, 2 ...
std::vector<double> counted_positions(std::size_t n);

/// Throws InputError unless there are at least two columns and two rows.
void check_counts(std::size_t columns, std::size_t rows, const std::string& name);
/// Throws InputError unless the positions are finite and ascend.
void check_positions(std::span<const double> positions, const char* axis, const std::string& name);

/// The heights, after these checks. Throws if all heights are NaN.
template <typename Sample>
std::unique_ptr<HeightSource> held_heights(std::vector<double> x, std::vector<double> y, std::vector<Sample> samples,
                                           SampleOrder order, const std::string& name) {
  check_counts(x.size(), y.size(), name);
  check_positions(x, "x", name);
  check_positions(y, "y", name);
  bool has_height = false;
  for (const Sample sample : samples) {
    has_height = !std::isnan(static_cast<double>(sample));
    if (has_height) break;
  }
  if (!has_height) throw InputError(name, "contains only NODATA values");
  return std::make_unique<HeldHeights<Sample>>(std::move(x), std::move(y), std::move(samples), order);
}

}  // namespace ligne
