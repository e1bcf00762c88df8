#pragma once
/// The u axis of the picture in columns of equal width.

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ligne::horizon {

class Columns {
 public:
  /// At least one column.
  Columns(double u_min, double u_max, std::size_t count)
      : u_min_(u_min), extent_(u_max - u_min), count_(std::max<std::size_t>(count, 1)) {
    const double width = extent_ / static_cast<double>(count_);
    width_ = width > 0 ? width : 1;
  }

  std::size_t count() const { return count_; }
  double extent() const { return extent_; }

  /// The column of u; the first or the last one for what lies outside.
  std::size_t at(double u) const {
    const double c = std::floor((u - u_min_) / width_);
    return c <= 0 ? 0 : std::min(static_cast<std::size_t>(c), count_ - 1);
  }
  /// Where column c begins.
  double begin(std::size_t c) const { return u_min_ + static_cast<double>(c) * width_; }

 private:
  double u_min_, extent_, width_;
  std::size_t count_;
};

}  // namespace ligne::horizon
