#pragma once
/// Finds the cells of a grid outside its samples.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ligne {

/// The cells of a grid of samples, with a frame of cells around it. A cell is outside if it belongs to the frame, or if
/// it has a hole at a corner and is connected to the frame across sides of such cells.
class OutsideCells {
 public:
  /// `is_sample(k)`: whether the surface exists at sample k, row by row.
  template <class IsSample>
  OutsideCells(std::size_t columns, std::size_t rows, IsSample is_sample)
      : width_(columns + 1), cells_(width_ * (rows + 1), kOpen) {
    for (std::size_t j = 0; j + 1 < rows; ++j) {
      for (std::size_t i = 0; i + 1 < columns; ++i) {
        const std::size_t k = j * columns + i;
        if (is_sample(k) && is_sample(k + 1) && is_sample(k + columns) && is_sample(k + columns + 1))
          cells_[(j + 1) * width_ + i + 1] = kFilled;
      }
    }
    std::vector<std::size_t> reached{0};
    cells_[0] = kOutside;
    const auto reach = [&](std::size_t cell) {
      if (cells_[cell] != kOpen) return;
      cells_[cell] = kOutside;
      reached.push_back(cell);
    };
    while (!reached.empty()) {
      const std::size_t cell = reached.back(), column = cell % width_;
      reached.pop_back();
      if (column > 0) reach(cell - 1);
      if (column + 1 < width_) reach(cell + 1);
      if (cell >= width_) reach(cell - width_);
      if (cell + width_ < cells_.size()) reach(cell + width_);
    }
  }

  /// Whether the cell with low corner (i, j) is outside. Samples count from 1; 0 is the frame.
  bool operator()(std::size_t i, std::size_t j) const { return cells_[j * width_ + i] == kOutside; }

 private:
  enum Kind : std::uint8_t { kOpen, kFilled, kOutside };
  std::size_t width_;
  std::vector<Kind> cells_;
};

}  // namespace ligne
