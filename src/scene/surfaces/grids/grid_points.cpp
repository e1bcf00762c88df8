// Blocks of lines "x y z", as in gnuplot: within a block, x or y is constant and the other has the same positions as in
// every block.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// Largest difference of positions that count as equal, relative to the narrowest step: rounding when they were
/// written. On a page it is 10 nanometres for a step of a centimetre.
constexpr double kPositionSlack = 0x1p-20;

const char* axis_name(std::size_t axis) { return axis == 0 ? "x" : "y"; }

double position(const PointRows& rows, std::size_t row, std::size_t axis) { return rows.values[3 * row + axis]; }

class PointGrid {
 public:
  PointGrid(PointRows rows, const std::string& name) : rows_(std::move(rows)), name_(name), count_(rows_.lines.size()) {}

  std::unique_ptr<HeightSource> make() {
    check();
    return finish();
  }

  /// Throws InputError if the points form no grid.
  void check() {
    check_blocks();
    find_axes();
    std::vector<double>&inner = inner_, &outer = outer_;
    inner.resize(block_size_);
    outer.resize(rows_.block_begins.size());
    for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = position(rows_, i, 1 - outer_axis_);
    for (std::size_t b = 0; b < outer.size(); ++b) outer[b] = position(rows_, b * block_size_, outer_axis_);
    const double inner_step = narrowest_step(inner, 1, 1 - outer_axis_);
    const double outer_step = narrowest_step(outer, block_size_, outer_axis_);
    for (std::size_t row = 0; row < count_; ++row) {
      check_point(row, outer_axis_, outer[row / block_size_], outer_step);
      check_point(row, 1 - outer_axis_, inner[row % block_size_], inner_step);
    }
  }

 private:
  InputError error(std::size_t row, const std::string& cause) const { return error_at_line(name_, rows_.lines[row], cause); }

  void check_blocks() {
    const std::vector<std::size_t>& begins = rows_.block_begins;
    block_size_ = begins.size() > 1 ? begins[1] : count_;
    for (std::size_t b = 0; b < begins.size(); ++b) {
      const std::size_t end = b + 1 < begins.size() ? begins[b + 1] : count_;
      if (end - begins[b] != block_size_) {
        throw error(end - 1, "block of " + std::to_string(end - begins[b]) + " points ends here; the first block has " +
                                 std::to_string(block_size_));
      }
    }
    if (block_size_ < 2)
      throw error(0, "block of a single point; the points of a grid come in blocks of one x or one y each");
    for (std::size_t row = 0; row < count_; ++row) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (!std::isfinite(position(rows_, row, axis))) throw error(row, std::string(axis_name(axis)) + " is not a number");
      }
    }
  }

  /// The axis that changes less over the first block is constant within blocks.
  void find_axes() {
    const double dx = std::abs(position(rows_, block_size_ - 1, 0) - position(rows_, 0, 0));
    const double dy = std::abs(position(rows_, block_size_ - 1, 1) - position(rows_, 0, 1));
    outer_axis_ = dx < dy ? 0 : 1;
  }

  /// Returns the narrowest step. Throws InputError unless the positions, `stride` rows apart, ascend or descend
  /// throughout.
  double narrowest_step(const std::vector<double>& positions, std::size_t stride, std::size_t axis) const {
    double narrowest = INFINITY;
    for (std::size_t i = 1; i < positions.size(); ++i) {
      const double step = positions[i] - positions[i - 1];
      if (step == 0 || (step > 0) != (positions[1] > positions[0])) {
        throw error(i * stride, std::string("positions ") + axis_name(axis) + " neither ascend nor descend throughout");
      }
      narrowest = std::min(narrowest, std::abs(step));
    }
    return narrowest;
  }

  void check_point(std::size_t row, std::size_t axis, double expected, double step) const {
    const double found = position(rows_, row, axis);
    if (std::abs(found - expected) <= kPositionSlack * step) return;
    throw error(row, std::string("the points do not form a grid: ") + axis_name(axis) + " is " + shortest(found) +
                         ", expected " + shortest(expected));
  }

  static std::string shortest(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
  }

  std::unique_ptr<HeightSource> finish() {
    std::vector<double>& z = rows_.values;
    for (std::size_t row = 0; row < count_; ++row) z[row] = z[3 * row + 2];
    z.resize(count_);
    z.shrink_to_fit();

    SampleOrder order{0, static_cast<std::ptrdiff_t>(block_size_), 1};
    if (outer_axis_ == 1) std::swap(order.step_x, order.step_y);
    std::vector<double> x = outer_axis_ == 0 ? std::move(outer_) : std::move(inner_);
    std::vector<double> y = outer_axis_ == 0 ? std::move(inner_) : std::move(outer_);
    if (x.front() > x.back()) order.turn(x, &SampleOrder::step_x);
    if (y.front() > y.back()) order.turn(y, &SampleOrder::step_y);
    return held_heights(std::move(x), std::move(y), std::move(z), order, name_);
  }

  PointRows rows_;
  const std::string& name_;
  std::size_t count_;
  std::size_t block_size_ = 0;
  std::vector<double> inner_, outer_;  ///< positions within a block, and of the blocks
  std::size_t outer_axis_ = 0;         ///< 0 if each block has one x, 1 if it has one y
};

}  // namespace

std::unique_ptr<HeightSource> grid_of_points(PointRows rows, const std::string& name) {
  return PointGrid(std::move(rows), name).make();
}

bool is_grid_of_blocks(const PointRows& rows, const std::string& name) {
  try {
    PointGrid(rows, name).check();
  } catch (const InputError&) {
    return false;
  }
  return true;
}

bool find_blocks(PointRows& rows) {
  const std::size_t count = rows.lines.size();
  if (count < 4) return false;
  for (const std::size_t outer : {std::size_t{0}, std::size_t{1}}) {
    std::size_t size = 1;
    while (size < count && position(rows, size, outer) == position(rows, 0, outer)) ++size;
    if (size < 2 || size == count || count % size != 0) continue;
    bool is_grid = true;
    for (std::size_t row = 0; is_grid && row < count; ++row) {
      is_grid = position(rows, row, outer) == position(rows, row - row % size, outer) &&
                position(rows, row, 1 - outer) == position(rows, row % size, 1 - outer);
    }
    if (!is_grid) continue;
    rows.block_begins.clear();
    for (std::size_t row = 0; row < count; row += size) rows.block_begins.push_back(row);
    return true;
  }
  return false;
}

}  // namespace ligne
