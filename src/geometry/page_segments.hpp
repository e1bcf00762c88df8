#pragma once
/// Overlaps of nearly parallel segments of the page, in plain doubles and mm, where micrometres do not matter.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::paper {

struct Segment {
  Point2 from{0, 0}, to{0, 0};
  double length() const { return glm::length(to - from); }
  Point2 at(double mm) const { return from + (to - from) * (mm / length()); }
};

/// A part of a segment, mm from its start.
struct Range {
  double from = 0, to = 0;
  double length() const { return to - from; }
};

/// The part of `base` beside which `other` lies within `lateral` of the line through `base`.
inline std::optional<Range> along(const Segment& base, const Segment& other, double lateral) {
  const double n = base.length();
  if (n == 0) return {};
  const Point2 d = (base.to - base.from) / n;
  const auto x = [&](Point2 p) { return glm::dot(p - base.from, d); };
  const auto y = [&](Point2 p) { return d.x * (p.y - base.from.y) - d.y * (p.x - base.from.x); };
  double x0 = x(other.from), x1 = x(other.to), y0 = y(other.from), y1 = y(other.to);
  if (std::min(y0, y1) > lateral || std::max(y0, y1) < -lateral) return {};
  // Cut the other segment where it leaves the band.
  const auto cut = [&](double level) { return x0 + (level - y0) / (y1 - y0) * (x1 - x0); };
  double first = x0, last = x1;
  if (y0 > lateral) first = cut(lateral);
  if (y0 < -lateral) first = cut(-lateral);
  if (y1 > lateral) last = cut(lateral);
  if (y1 < -lateral) last = cut(-lateral);
  const Range range{std::max(0.0, std::min(first, last)), std::min(n, std::max(first, last))};
  if (range.from > range.to) return {};
  return range;
}

/// Largest distance of a point of `other` from the line through `base`.
inline double deviation(const Segment& base, const Segment& other) {
  const double n = base.length();
  if (n == 0) return 0;
  const Point2 d = (base.to - base.from) / n;
  const auto y = [&](Point2 p) { return std::abs(d.x * (p.y - base.from.y) - d.y * (p.x - base.from.x)); };
  return std::max(y(other.from), y(other.to));
}

/// The parts of [from, to] that no range covers, ascending.
inline std::vector<Range> gaps(std::vector<Range> ranges, double from, double to) {
  std::sort(ranges.begin(), ranges.end(), [](const Range& l, const Range& r) { return l.from < r.from; });
  std::vector<Range> result;
  double reached = from;
  for (const Range& r : ranges) {
    if (r.from > reached) result.push_back({reached, std::min(r.from, to)});
    reached = std::max(reached, r.to);
    if (reached >= to) break;
  }
  if (reached < to) result.push_back({reached, to});
  std::erase_if(result, [](const Range& r) { return r.length() <= 0; });
  return result;
}

/// Length of the common interval, after projection onto the line of the longer segment. It is 0 if the shorter segment
/// is at most `lateral` long, or farther than that from the line anywhere in the interval. So a wedge (two segments that
/// leave one point at an angle) counts only if it stays within `lateral`.
inline double common_length(const Segment& a, const Segment& b, double lateral) {
  const bool swapped = b.length() > a.length();
  const Segment &base = swapped ? b : a, &other = swapped ? a : b;
  const double n = base.length();
  if (other.length() <= lateral) return 0;
  const Point2 d = (base.to - base.from) / n;
  const auto x = [&](Point2 p) { return glm::dot(p - base.from, d); };
  const double x0 = x(other.from), x1 = x(other.to);
  const double from = std::max(0.0, std::min(x0, x1)), to = std::min(n, std::max(x0, x1));
  if (to <= from) return 0;
  const auto on_other = [&](double v) { return other.from + (other.to - other.from) * ((v - x0) / (x1 - x0)); };
  const Segment part{on_other(from), on_other(to)};
  return deviation(base, part) <= lateral ? to - from : 0;
}

}  // namespace ligne::paper
