#include "plotting/paths/known_ellipses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Number of squares along the longer side of the page. Adjustable.
constexpr std::size_t kSquares = 128;
/// Least and largest number of points at which the way of an ellipse through the squares is followed.
constexpr double kLeastPoints = 16, kMostPoints = 4096;

}  // namespace

KnownEllipses::KnownEllipses(std::vector<Ellipse> ellipses, const Rect& page)
    : page_(page),
      squares_per_mm_(kSquares / std::max(page.width(), page.height())),
      ellipses_(std::move(ellipses)),
      begin_(kSquares * kSquares + 1, 0) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;   // square, ellipse
  std::vector<std::uint32_t> last(kSquares * kSquares, kNone);  // per square: the last ellipse found there
  for (std::uint32_t i = 0; i < ellipses_.size(); ++i) {
    frames_.emplace_back(ellipses_[i]);
    for_boxes(i, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin / kSquares; row <= end / kSquares; ++row) {
        for (std::size_t square = row * kSquares + begin % kSquares; square <= row * kSquares + end % kSquares; ++square) {
          if (std::exchange(last[square], i) == i) continue;
          found.emplace_back(static_cast<std::uint32_t>(square), i);
          ++begin_[square + 1];
        }
      }
    });
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  in_square_.resize(found.size());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (const auto& [square, ellipse] : found) in_square_[next[square]++] = ellipse;
}

/// Calls visit(first, last) for the squares at two corners of each of the boxes that hold an ellipse together.
template <class Visit>
void KnownEllipses::for_boxes(std::size_t i, const Visit& visit) const {
  const Ellipse& e = ellipses_[i];
  // About one box for each square. Between two points the ellipse leaves the box of both by less than `beside`.
  const double count = std::clamp(std::ceil(2 * std::numbers::pi * e.radii.x * squares_per_mm_), kLeastPoints, kMostPoints);
  const double step = 2 * std::numbers::pi / count, cosine = std::cos(step), sine = std::sin(step);
  const double beside = kNearMm + e.radii.x * (1 - std::cos(step / 2));
  const Point2 along = e.radii.x * Point2(std::cos(e.rotation), std::sin(e.rotation));
  const Point2 across = e.radii.y * Point2(-std::sin(e.rotation), std::cos(e.rotation));
  Point2 unit(1, 0), from = e.centre + along;
  for (double k = 0; k < count; ++k) {
    unit = {cosine * unit.x - sine * unit.y, sine * unit.x + cosine * unit.y};
    const Point2 to = e.centre + unit.x * along + unit.y * across;
    const Point2 low = glm::min(from, to) - beside, high = glm::max(from, to) + beside;
    from = to;
    if (high.x < page_.min.x || high.y < page_.min.y || low.x > page_.max.x || low.y > page_.max.y) continue;
    visit(square_of(low), square_of(high));
  }
}

/// The square of a point. Points outside the page count to the squares at its rim.
std::size_t KnownEllipses::square_of(Point2 p) const {
  const auto cell = [&](double offset) {
    return static_cast<std::size_t>(std::clamp(offset * squares_per_mm_, 0.0, kSquares - 1.0));
  };
  return cell(p.y - page_.min.y) * kSquares + cell(p.x - page_.min.x);
}

bool KnownEllipses::is_on(std::size_t i, Point2 p, double tolerance) const {
  const Point2 unit = frames_[i].to_unit(p);
  // The distance is no less than the shorter radius times the distance from the unit circle.
  const double most = tolerance / ellipses_[i].radii.y;
  if (std::abs(glm::dot(unit, unit) - 1) > most * (2 + most)) return false;
  return frames_[i].distance(unit) <= tolerance;
}

std::span<const std::uint32_t> KnownEllipses::near(Point2 p) const {
  const std::size_t square = square_of(p);
  return {in_square_.data() + begin_[square], in_square_.data() + begin_[square + 1]};
}

}  // namespace ligne
