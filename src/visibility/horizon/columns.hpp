#pragma once
/// Columns of equal width that divide the u axis of the picture, and bands of columns that are studied in parallel.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

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

  /// The column of u; outside the picture, the first or the last column.
  std::size_t at(double u) const {
    const double c = (u - u_min_) / width_;
    return c <= 0 ? 0 : std::min(static_cast<std::size_t>(c), count_ - 1);
  }
  /// The place u at which column c begins.
  double begin(std::size_t c) const { return u_min_ + static_cast<double>(c) * width_; }

 private:
  double u_min_, extent_, width_;
  std::size_t count_;
};

/// Largest mean number of columns that an edge of a grid spans. With more, a grid of few long rows costs the square of
/// their number.
inline constexpr double kMostSpanned = 32;

/// Number of columns for a grid of nx by ny samples whose sides have these widths across the picture: as many as curves,
/// unless its edges span too many.
inline std::size_t column_count(std::size_t nx, double width_x, std::size_t ny, double width_y) {
  const double x = std::abs(width_x), y = std::abs(width_y);
  const double mean_step = (x / static_cast<double>(nx) + y / static_cast<double>(ny)) / 2;
  const double most = kMostSpanned * (x + y) / mean_step;
  return most < static_cast<double>(nx + ny) ? static_cast<std::size_t>(most) : nx + ny;
}

/// Columns from begin to end - 1.
struct ColumnRange {
  std::size_t begin, end;
  bool holds(std::size_t c) const { return begin <= c && c < end; }
};

/// Divides the columns into at most kMostBands bands of nearly equal size. The number of bands does not depend on the
/// number of threads.
class Bands {
 public:
  static constexpr std::size_t kMostBands = 16;

  explicit Bands(const Columns& columns) : columns_(columns), size_(std::min(kMostBands, columns.count())) {
    for (std::size_t band = 0; band < size_; ++band) of_column_.resize(of_band(band).end, static_cast<std::uint16_t>(band));
  }

  const Columns& columns() const { return columns_; }
  std::size_t size() const { return size_; }
  ColumnRange of_band(std::size_t band) const {
    return {band * columns_.count() / size_, (band + 1) * columns_.count() / size_};
  }
  std::uint16_t of_column(std::size_t c) const { return of_column_[c]; }

 private:
  Columns columns_;
  std::size_t size_;
  std::vector<std::uint16_t> of_column_;
};

/// The columns that a band holds: its own, and one more on either side for places just beyond its borders.
inline ColumnRange with_neighbours(ColumnRange own, const Columns& columns) {
  return {own.begin - std::min<std::size_t>(own.begin, 1), std::min(own.end + 1, columns.count())};
}

}  // namespace ligne::horizon
