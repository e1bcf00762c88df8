#include "clear/page_lines.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/nearest_on_segment.hpp"

namespace ligne::test {

PageLines::PageLines(const Rect& sheet, double cell_mm)
    : sheet_(sheet),
      cell_mm_(cell_mm),
      columns_(static_cast<int>((sheet.max.x - sheet.min.x) / cell_mm) + 1),
      rows_(static_cast<int>((sheet.max.y - sheet.min.y) / cell_mm) + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

template <class Visit>
void PageLines::each_cell(Point2 low, Point2 high, const Visit& visit) const {
  const auto cell = [&](double offset, int count) {
    return std::clamp(static_cast<int>(std::floor(offset / cell_mm_)), 0, count - 1);
  };
  for (int y = cell(low.y - sheet_.min.y, rows_); y <= cell(high.y - sheet_.min.y, rows_); ++y) {
    for (int x = cell(low.x - sheet_.min.x, columns_); x <= cell(high.x - sheet_.min.x, columns_); ++x) {
      visit(static_cast<std::size_t>(y * columns_ + x));
    }
  }
}

void PageLines::add(Point2 from, Point2 to) {
  // Pieces of about a cell, so that a slanting line lies in few cells that it does not pass.
  const int pieces = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / cell_mm_)));
  for (int k = 0; k < pieces; ++k) {
    const Point2 a = from + (to - from) * (double(k) / pieces), b = from + (to - from) * (double(k + 1) / pieces);
    each_cell(glm::min(a, b), glm::max(a, b),
              [&](std::size_t cell) { cells_[cell].push_back(static_cast<std::uint32_t>(segments_.size())); });
    segments_.push_back({a, b});
  }
}

double PageLines::distance(Point2 p, double limit_mm) const {
  double nearest = limit_mm;
  each_cell(p - Point2(limit_mm), p + Point2(limit_mm), [&](std::size_t cell) {
    for (const std::uint32_t i : cells_[cell]) {
      const auto& [from, to] = segments_[i];
      nearest = std::min(nearest, glm::length(from + nearest_on_segment(p, from, to) * (to - from) - p));
    }
  });
  return nearest;
}

}  // namespace ligne::test
