#pragma once
/// Things of the page in square cells, so that those near a point are found without a look at all of them.

#include "geometry/page_segments.hpp"
#include "support/standard.hpp"

namespace ligne::test {

using paper::along;
using paper::common_length;
using paper::deviation;
using paper::gaps;
using paper::Range;
using paper::Segment;

/// The distance of a point from a segment.
inline double distance_to_segment(Point2 p, Point2 a, Point2 b) {
  const Point2 along = b - a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return glm::distance(p, a + along * t);
}

/// Numbers of things by the cells that their upright boxes meet. Places beyond the extent count to the cells at its rim.
class PageCells {
 public:
  PageCells(const Rect& extent, double cell_mm)
      : origin_(extent.min),
        cell_mm_(cell_mm),
        columns_(static_cast<int>(extent.width() / cell_mm) + 1),
        rows_(static_cast<int>(extent.height() / cell_mm) + 1),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  void add(Point2 low, Point2 high, std::uint32_t number) {
    each_cell(low, high, [&](std::size_t cell) { cells_[cell].push_back(number); });
  }

  /// Calls visit(number) for all whose cells the box meets, once for each of these cells.
  template <class Visit>
  void each(Point2 low, Point2 high, const Visit& visit) const {
    each_cell(low, high, [&](std::size_t cell) { std::for_each(cells_[cell].begin(), cells_[cell].end(), visit); });
  }

 private:
  template <class Visit>
  void each_cell(Point2 low, Point2 high, const Visit& visit) const {
    const auto cell = [&](double offset, int count) {
      return static_cast<int>(std::clamp(std::floor(offset / cell_mm_), 0.0, count - 1.0));
    };
    const int last_row = cell(high.y - origin_.y, rows_), last_column = cell(high.x - origin_.x, columns_);
    for (int y = cell(low.y - origin_.y, rows_); y <= last_row; ++y)
      for (int x = cell(low.x - origin_.x, columns_); x <= last_column; ++x)
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x));
  }

  Point2 origin_;
  double cell_mm_;
  int columns_, rows_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

/// Segments of the page, asked for the nearest one.
class PageLines {
 public:
  /// `cell_mm` is about the distance that is asked for, or more.
  PageLines(const Rect& sheet, double cell_mm) : cells_(sheet, cell_mm), cell_mm_(cell_mm) {}

  void add(Point2 from, Point2 to) {
    // Pieces of about a cell, so that a slanting line lies in few cells that it does not pass.
    const int pieces = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / cell_mm_)));
    for (int k = 0; k < pieces; ++k) {
      const Point2 a = from + (to - from) * (double(k) / pieces), b = from + (to - from) * (double(k + 1) / pieces);
      cells_.add(glm::min(a, b), glm::max(a, b), static_cast<std::uint32_t>(segments_.size()));
      segments_.push_back({a, b});
    }
  }

  /// The distance of the nearest segment; `limit` if none is as near as that.
  double distance(Point2 p, double limit) const {
    double nearest = limit;
    cells_.each(p - Point2(limit), p + Point2(limit), [&](std::uint32_t i) {
      nearest = std::min(nearest, distance_to_segment(p, segments_[i][0], segments_[i][1]));
    });
    return nearest;
  }

 private:
  PageCells cells_;
  double cell_mm_;
  std::vector<std::array<Point2, 2>> segments_;
};

}  // namespace ligne::test
