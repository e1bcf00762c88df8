#include "picture/choice/cover_samples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ligne {
namespace {

/// x of the side at that height. It is bit for bit equal for the triangles on both sides of it.
double x_at(Point2 a, Point2 b, double y) {
  if (std::pair(b.y, b.x) < std::pair(a.y, a.x)) std::swap(a, b);
  return a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
}

}  // namespace

CoverSamples::CoverSamples(const Rect& around, std::uint32_t rows) : rows_(rows), corner_(around.min) {
  const double width = around.max.x - around.min.x, height = around.max.y - around.min.y;
  const double columns = height > 0 ? std::ceil(rows * width / height) : kMostColumns;
  columns_ = static_cast<std::uint32_t>(std::clamp(columns, 1.0, double(kMostColumns)));
  width_ = width > 0 ? width / columns_ : 1;
  height_ = height > 0 ? height / rows_ : 1;
  steps_.assign(std::size_t{columns_ + 1} * rows_, 0);
}

void CoverSamples::add(const std::array<Point2, 3>& corners) {
  // The sample points have rows r with r + 1/2 in [low, high), and columns likewise.
  const auto first = [](double v, std::uint32_t n) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(v - 0.5), 0.0, double(n)));
  };
  std::array<Point2, 3> p{};
  for (int k = 0; k < 3; ++k) p[k] = {(corners[k].x - corner_.x) / width_, (corners[k].y - corner_.y) / height_};
  const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
  for (std::uint32_t row = first(low, rows_); row < first(high, rows_); ++row) {
    const double y = row + 0.5;
    double left = columns_, right = 0;
    for (int k = 0; k < 3; ++k) {
      const Point2 a = p[k], b = p[(k + 1) % 3];
      if ((a.y <= y) == (b.y <= y)) continue;
      const double x = x_at(a, b, y);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    if (!(left < right)) continue;
    std::int32_t* steps = steps_.data() + std::size_t{columns_ + 1} * row;
    ++steps[first(left, columns_)];
    --steps[first(right, columns_)];
  }
}

CoverSamples::Cover CoverSamples::cover() const {
  Cover cover;
  std::uint64_t sum = 0, covered = 0;
  for (std::uint32_t row = 0; row < rows_; ++row) {
    std::int32_t count = 0;
    for (std::uint32_t column = 0; column < columns_; ++column) {
      count += steps_[std::size_t{columns_ + 1} * row + column];
      sum += static_cast<std::uint64_t>(count);
      covered += count > 0;
      cover.most = std::max(cover.most, static_cast<std::uint32_t>(count));
    }
  }
  if (covered > 0) cover.mean = static_cast<double>(sum) / static_cast<double>(covered);
  cover.share = static_cast<double>(covered) / (double(rows_) * columns_);
  return cover;
}

}  // namespace ligne
