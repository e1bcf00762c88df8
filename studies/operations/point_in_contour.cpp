#include "studies/operations/point_in_contour.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace ligne::studies {
namespace {

double sign_of(LatticePoint a, LatticePoint b, LatticePoint p, ContourCounts& counts) {
  ++counts.signs;
  return orientation(a, b, p);
}

/// Place of a point p on the line ab: on the side, on one of its ends, or outside.
Place on_line(LatticePoint a, LatticePoint b, LatticePoint p, ContourCounts& counts) {
  counts.comparisons += 4;
  if (p == a || p == b) return Place::on_corner;
  const bool between =
      std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
  return between ? Place::on_side : Place::outside;
}

LatticePoint next(std::span<const LatticePoint> contour, std::size_t i) {
  return contour[i + 1 < contour.size() ? i + 1 : 0];
}

}  // namespace

Place by_crossings(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts, ContourKind kind) {
  bool inside = false;
  int crossed = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const LatticePoint a = contour[i], b = next(contour, i);
    ++counts.sides;
    counts.comparisons += 2;
    if ((a.y > p.y) == (b.y > p.y)) {
      counts.comparisons += 1;
      if (a.y == p.y || b.y == p.y) {
        const Place place = sign_of(a, b, p, counts) == 0 ? on_line(a, b, p, counts) : Place::outside;
        if (place != Place::outside) return place;
      }
      continue;
    }
    const double sign = sign_of(a, b, p, counts);
    if (sign == 0) return on_line(a, b, p, counts);
    inside ^= (sign > 0) == (b.y > a.y);
    crossed += a.y != p.y && b.y != p.y;
    if (kind == ContourKind::convex && crossed == 2) break;
  }
  return inside ? Place::inside : Place::outside;
}

Place by_angles(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts, ContourKind kind) {
  double sum = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const LatticePoint a = contour[i], b = next(contour, i);
    const double ax = double(a.x) - p.x, ay = double(a.y) - p.y, bx = double(b.x) - p.x, by = double(b.y) - p.y;
    ++counts.sides;
    ++counts.angles;
    const double angle = std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    if (kind == ContourKind::convex && angle * sum < 0) return Place::outside;
    sum += angle;
  }
  return std::abs(sum) > 1 ? Place::inside : Place::outside;
}

Place by_half_planes(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts) {
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const LatticePoint a = contour[i], b = next(contour, i);
    ++counts.sides;
    const double sign = sign_of(a, b, p, counts);
    if (sign < 0) return Place::outside;
    if (sign == 0) return on_line(a, b, p, counts);
  }
  return Place::inside;
}

Place by_unoriented_half_planes(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts) {
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const LatticePoint a = contour[i], b = next(contour, i);
    ++counts.sides;
    const double sign = sign_of(a, b, p, counts);
    if (sign == 0) return on_line(a, b, p, counts);
    double inner = 0;  // corners collinear with the side do not decide
    for (std::size_t k = i + 2; inner == 0 && k < i + contour.size(); ++k)
      inner = sign_of(a, b, contour[k % contour.size()], counts);
    if ((sign > 0) != (inner > 0)) return Place::outside;
  }
  return Place::inside;
}

Place by_triangles(std::span<const LatticePoint> contour, LatticePoint p, ContourCounts& counts) {
  // Triangles (0, i, i + 1): the diagonal from 0 to i + 1 is tested once for its two triangles.
  const LatticePoint o = contour[0];
  counts.sides += 1;
  double before = sign_of(o, contour[1], p, counts);
  if (before < 0) return Place::outside;
  if (before == 0) return on_line(o, contour[1], p, counts);
  for (std::size_t i = 1; i + 1 < contour.size(); ++i) {
    counts.sides += 2;
    const double outer = sign_of(contour[i], contour[i + 1], p, counts), after = sign_of(o, contour[i + 1], p, counts);
    if (outer == 0) {
      const Place place = on_line(contour[i], contour[i + 1], p, counts);
      if (place != Place::outside) return place;
    }
    if (before >= 0 && outer > 0 && after <= 0) {
      // On the last diagonal the point is on the contour; otherwise it is inside.
      if (after == 0 && i + 2 == contour.size()) return on_line(o, contour[i + 1], p, counts);
      return Place::inside;
    }
    if (outer < 0) return Place::outside;
    before = after;
  }
  return Place::outside;
}

Sectors::Sectors(std::span<const LatticePoint> contour) : contour_(contour.begin(), contour.end()) {
  for (const LatticePoint c : contour_) {
    x_ += double(c.x) / double(contour_.size());
    y_ += double(c.y) / double(contour_.size());
  }
  for (const LatticePoint c : contour_) angles_.push_back(std::atan2(c.y - y_, c.x - x_));
  first_ = static_cast<std::size_t>(std::min_element(angles_.begin(), angles_.end()) - angles_.begin());
  std::rotate(angles_.begin(), angles_.begin() + static_cast<std::ptrdiff_t>(first_), angles_.end());
  std::rotate(contour_.begin(), contour_.begin() + static_cast<std::ptrdiff_t>(first_), contour_.end());
}

Place Sectors::by_angle(LatticePoint p, ContourCounts& counts) const {
  ++counts.angles;
  const double angle = std::atan2(p.y - y_, p.x - x_);
  std::size_t low = 0, high = angles_.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    ++counts.comparisons;
    if (angles_[middle] <= angle) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  // A direction below the first angle lies in the last sector.
  const std::size_t i = low == 0 ? angles_.size() - 1 : low - 1;
  ++counts.sides;
  const LatticePoint a = contour_[i], b = next(contour_, i);
  const double sign = sign_of(a, b, p, counts);
  if (sign == 0) return on_line(a, b, p, counts);
  return sign > 0 ? Place::inside : Place::outside;
}

Place Sectors::by_signs(LatticePoint p, ContourCounts& counts) const {
  const std::size_t n = contour_.size();
  const LatticePoint o = contour_[0];
  const double first = sign_of(o, contour_[1], p, counts), last = sign_of(o, contour_[n - 1], p, counts);
  if (first < 0 || last > 0) return Place::outside;
  if (first == 0) return on_line(o, contour_[1], p, counts);
  if (last == 0) return on_line(o, contour_[n - 1], p, counts);
  // Invariant: the point lies before the diagonal to `high`, and not before the diagonal to `low`.
  std::size_t low = 1, high = n - 1;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    if (sign_of(o, contour_[middle], p, counts) >= 0) {
      low = middle;
    } else {
      high = middle;
    }
  }
  ++counts.sides;
  const double sign = sign_of(contour_[low], contour_[high], p, counts);
  if (sign == 0) return on_line(contour_[low], contour_[high], p, counts);
  return sign > 0 ? Place::inside : Place::outside;
}

Place by_codes(std::span<const LatticePoint> contour, LatticePoint p, bool mend, ContourCounts& counts) {
  // Octants round the point by the signs of the two differences, counted from +x towards +y; 8 is the point itself.
  const auto code = [&](LatticePoint c) {
    constexpr int kCodes[3][3] = {{5, 4, 3}, {6, 8, 2}, {7, 0, 1}};
    counts.comparisons += 4;
    return kCodes[(c.x > p.x) - (c.x < p.x) + 1][(c.y > p.y) - (c.y < p.y) + 1];
  };
  int sum = 0, before = code(contour[0]);
  if (before == 8) return Place::on_corner;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const LatticePoint a = contour[i], b = next(contour, i);
    const int after = code(b);
    ++counts.sides;
    if (after == 8) return Place::on_corner;
    int passed = after - before;
    counts.comparisons += 1;
    if (mend && std::abs(passed) == 4) {
      const double sign = sign_of(a, b, p, counts);
      if (sign == 0) return Place::on_side;
      passed = sign > 0 ? 4 : -4;
    } else if (std::abs(passed) > 3) {
      passed += passed < 0 ? 8 : -8;
    }
    sum += passed;
    before = after;
  }
  return sum != 0 ? Place::inside : Place::outside;
}

}  // namespace ligne::studies
