#include "stroke_grid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ligne::check {

namespace {

constexpr double kCellMm = 0.5;

}  // namespace

double distance_mm(Point2 p, const PageSegment& s) {
  const Point2 along = s.b - s.a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - s.a, along) / length2, 0.0, 1.0) : 0;
  return glm::distance(p, s.a + along * t);
}

StrokeGrid::StrokeGrid(std::vector<PageSegment> segments, double reach_mm)
    : segments_(std::move(segments)), reach_(reach_mm) {
  Rect extent;
  for (const PageSegment& s : segments_) extent.extend(s.a), extent.extend(s.b);
  if (extent.empty()) return;
  origin_ = extent.min - Point2{kCellMm, kCellMm};
  columns_ = static_cast<std::int64_t>(extent.width() / kCellMm) + 3;
  rows_ = static_cast<std::int64_t>(extent.height() / kCellMm) + 3;
  begin_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  for (const PageSegment& s : segments_) visit_cells(s, [&](std::size_t cell) { ++begin_[cell + 1]; });
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  members_.resize(begin_.back());
  std::vector<std::uint32_t> fill(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t i = 0; i < segments_.size(); ++i) {
    visit_cells(segments_[i], [&](std::size_t cell) { members_[fill[cell]++] = i; });
  }
}

template <class Visit>
void StrokeGrid::visit_cells(const PageSegment& s, const Visit& visit) const {
  // Row by row the columns that the segment, widened by the reach, passes.
  const auto index = [](double offset, std::int64_t count) {
    return std::clamp(static_cast<std::int64_t>(std::floor(offset / kCellMm)), std::int64_t{0}, count - 1);
  };
  const Point2 low = glm::min(s.a, s.b) - origin_, high = glm::max(s.a, s.b) - origin_;
  const std::int64_t row_end = index(high.y + reach_, rows_);
  for (std::int64_t row = index(low.y - reach_, rows_); row <= row_end; ++row) {
    double x_from = low.x, x_to = high.x;
    const double dy = s.b.y - s.a.y;
    if (std::abs(dy) > kCellMm) {
      const double y0 = static_cast<double>(row) * kCellMm - reach_ + origin_.y, y1 = y0 + kCellMm + 2 * reach_;
      const double t0 = std::clamp((y0 - s.a.y) / dy, 0.0, 1.0), t1 = std::clamp((y1 - s.a.y) / dy, 0.0, 1.0);
      const double xa = s.a.x + (s.b.x - s.a.x) * t0 - origin_.x, xb = s.a.x + (s.b.x - s.a.x) * t1 - origin_.x;
      x_from = std::min(xa, xb), x_to = std::max(xa, xb);
    }
    const std::int64_t column_end = index(x_to + reach_, columns_);
    for (std::int64_t column = index(x_from - reach_, columns_); column <= column_end; ++column) {
      visit(static_cast<std::size_t>(row * columns_ + column));
    }
  }
}

bool StrokeGrid::near(Point2 p) const {
  const Point2 at = (p - origin_) / kCellMm;
  // Cells lie one beyond the extent on every side, which is more than the reach.
  if (columns_ == 0 ||
      !(at.x >= 0 && at.y >= 0 && at.x < static_cast<double>(columns_) && at.y < static_cast<double>(rows_))) {
    return false;
  }
  const auto cell = static_cast<std::size_t>(static_cast<std::int64_t>(at.y) * columns_ + static_cast<std::int64_t>(at.x));
  for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
    if (distance_mm(p, segments_[members_[i]]) <= reach_) return true;
  }
  return false;
}

}  // namespace ligne::check
