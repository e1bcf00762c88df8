#include "study/operations/contour_clipping.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace ligne::studies {
namespace {

double side_of(Point2 a, Point2 b, Point2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

/// The lower or upper half of a convex contour, from left to right, without its upright sides.
std::vector<Point2> chain(const Contour& contour, bool upper) {
  const std::size_t n = contour.size();
  // Of corners at one abscissa the outer one of the half.
  const auto outer = [&](Point2 p, Point2 q) { return upper ? p.y > q.y : p.y < q.y; };
  std::size_t first = 0, last = 0;
  for (std::size_t i = 1; i < n; ++i) {
    const Point2 p = contour[i];
    if (p.x < contour[first].x || (p.x == contour[first].x && outer(p, contour[first]))) first = i;
    if (p.x > contour[last].x || (p.x == contour[last].x && outer(p, contour[last]))) last = i;
  }
  std::vector<Point2> points{contour[first]};
  for (std::size_t i = first; i != last;) {
    i = upper ? (i + n - 1) % n : (i + 1) % n;
    points.push_back(contour[i]);
  }
  return points;
}

/// Walks a chain with rising abscissas.
class ChainWalk {
 public:
  explicit ChainWalk(std::vector<Point2> points) : points_(std::move(points)) {}
  double at(double x) {
    while (i_ + 2 < points_.size() && points_[i_ + 1].x <= x) ++i_;
    const Point2 a = points_[i_], b = points_[i_ + 1];
    return x <= a.x ? a.y : x >= b.x ? b.y : a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x));
  }
  bool degenerate() const { return points_.size() < 2; }
  std::span<const Point2> points() const { return points_; }

 private:
  std::vector<Point2> points_;
  std::size_t i_ = 0;
};

}  // namespace

Contour clip_side_by_side(const Contour& subject, const Contour& clip, ContourClipCounts& counts) {
  Contour list = subject;
  for (std::size_t i = 0; i < clip.size() && !list.empty(); ++i) {
    const Point2 a = clip[i], b = clip[(i + 1) % clip.size()];
    Contour kept;
    Point2 from = list.back();
    double of_from = side_of(a, b, from);
    ++counts.signs;
    for (const Point2 to : list) {
      const double of_to = side_of(a, b, to);
      ++counts.signs;
      if ((of_from < 0) != (of_to < 0) && of_from != 0 && of_to != 0) {
        ++counts.crossings;
        kept.push_back(from + (to - from) * (of_from / (of_from - of_to)));
      }
      if (of_to >= 0) kept.push_back(to);
      from = to;
      of_from = of_to;
    }
    list = std::move(kept);
  }
  return list;
}

Contour clip_convex(const Contour& a, const Contour& b, ContourClipCounts& counts) {
  std::array<ChainWalk, 2> lower{ChainWalk(chain(a, false)), ChainWalk(chain(b, false))};
  std::array<ChainWalk, 2> upper{ChainWalk(chain(a, true)), ChainWalk(chain(b, true))};
  for (const auto* pair : {&lower, &upper}) {
    if ((*pair)[0].degenerate() || (*pair)[1].degenerate()) return {};
  }
  const double left = std::max(lower[0].points().front().x, lower[1].points().front().x);
  const double right = std::min(lower[0].points().back().x, lower[1].points().back().x);
  // The abscissas of all corners, four rising lists merged.
  std::vector<double> slabs{left};
  std::vector<double> merged;
  for (const auto* pair : {&lower, &upper}) {
    for (const ChainWalk& walk : *pair) {
      std::vector<double> xs;
      for (const Point2 p : walk.points()) xs.push_back(p.x);
      std::vector<double> both(merged.size() + xs.size());
      std::merge(merged.begin(), merged.end(), xs.begin(), xs.end(), both.begin());
      merged = std::move(both);
    }
  }
  for (const double x : merged) {
    if (x > slabs.back() && x < right) slabs.push_back(x);
  }
  if (!(left < right)) return {};
  slabs.push_back(right);

  Contour below, above;
  for (std::size_t i = 0; i + 1 < slabs.size(); ++i) {
    const double x0 = slabs[i], x1 = slabs[i + 1];
    std::array<double, 4> y0, y1;  // lower a, lower b, upper a, upper b
    for (std::size_t k = 0; k < 2; ++k) {
      y0[k] = lower[k].at(x0);
      y0[k + 2] = upper[k].at(x0);
    }
    for (std::size_t k = 0; k < 2; ++k) {
      y1[k] = lower[k].at(x1);
      y1[k + 2] = upper[k].at(x1);
    }
    // Where two of the four sides change places within the slab.
    std::vector<double> parts{0, 1};
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = p + 1; q < 4; ++q) {
        const double d0 = y0[p] - y0[q], d1 = y1[p] - y1[q];
        ++counts.signs;
        if ((d0 < 0) == (d1 < 0) || d0 == 0 || d1 == 0) continue;
        ++counts.crossings;
        parts.push_back(d0 / (d0 - d1));
      }
    }
    std::sort(parts.begin(), parts.end());
    const auto y = [&](std::size_t k, double t) { return y0[k] + (y1[k] - y0[k]) * t; };
    const auto low = [&](double t) { return std::max(y(0, t), y(1, t)); };
    const auto high = [&](double t) { return std::min(y(2, t), y(3, t)); };
    const auto add = [&](Contour& half, Point2 p) {
      if (half.empty() || half.back() != p) half.push_back(p);
    };
    // Between two such places the contours overlap all along or nowhere, as in the middle; at its ends lower and upper sides
    // may have met, and differ by a rounding.
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
      const double middle = (parts[k] + parts[k + 1]) / 2;
      if (!(low(middle) < high(middle))) continue;
      for (const double t : {parts[k], parts[k + 1]}) {
        const double x = x0 + (x1 - x0) * t;
        add(below, {x, low(t)});
        add(above, {x, std::max(low(t), high(t))});
      }
    }
  }
  if (below.size() < 2 && above.size() < 2) return {};
  below.insert(below.end(), above.rbegin(), above.rend());
  return below;
}

double twice_area_of(const Contour& contour) {
  double sum = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Point2 a = contour[i] - contour[0], b = contour[(i + 1) % contour.size()] - contour[0];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

}  // namespace ligne::studies
