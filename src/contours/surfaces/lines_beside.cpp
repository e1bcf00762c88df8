#include "contours/surfaces/lines_beside.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/nearest_on_segment.hpp"

namespace ligne {
namespace {

/// Least cosine of the angle between an edge and a line that runs beside it: 45 degrees.
constexpr double kBesideCosine = 0.70710678;

double distance(Point2 p, const OutlineSegment& s) {
  return glm::length(s.from + nearest_on_segment(p, s.from, s.to) * (s.to - s.from) - p);
}

/// An interval of fractions, empty where the first exceeds the last.
struct Interval {
  double first = 0, last = 1;

  /// Keeps the fractions at which a linear function with these values at 0 and 1 lies between the bounds.
  void keep(double at_0, double at_1, double low, double high) {
    const double rise = at_1 - at_0;
    if (rise == 0) {
      if (at_0 < low || at_0 > high) last = -1;
      return;
    }
    const double a = (low - at_0) / rise, b = (high - at_0) / rise;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
};

/// The part of from-to beside which a segment runs.
Interval covered_by(const OutlineSegment& s, Point2 from, Point2 to, double reach, double slack_mm) {
  const Point2 edge = to - from, d = s.to - s.from;
  const double length = glm::length(d);
  if (length == 0 || std::abs(glm::dot(edge, d)) < kBesideCosine * length * glm::length(edge)) return {1, 0};
  const auto along = [&](Point2 p) { return glm::dot(p - s.from, d) / length; };
  const auto across = [&](Point2 p) { return (d.x * (p.y - s.from.y) - d.y * (p.x - s.from.x)) / length; };
  Interval covered;
  covered.keep(along(from), along(to), -slack_mm, length + slack_mm);
  covered.keep(across(from), across(to), -reach, reach);
  return covered;
}

}  // namespace

bool LinesBeside::any_within(Point2 p, double reach) const {
  bool any = false;
  finder_.near(p - Point2(reach), p + Point2(reach), [&](const OutlineSegment& s) { any |= distance(p, s) <= reach; });
  return any;
}

std::optional<Point2> LinesBeside::nearest_end(Point2 p, double reach) const {
  std::optional<Point2> best;
  const auto offer = [&](Point2 q) {
    const double d = glm::length(q - p);
    if (d <= reach && (!best || d < glm::length(*best - p))) best = q;
  };
  finder_.near(p - Point2(reach), p + Point2(reach), [&](const OutlineSegment& s) {
    offer(s.from);
    offer(s.to);
  });
  return best;
}

std::vector<std::array<double, 2>> LinesBeside::uncovered(Point2 from, Point2 to, double reach, double slack_mm) const {
  std::vector<std::array<double, 2>> covered, left;
  for_steps(from, to, reach, [&](Point2 low, Point2 high) {
    finder_.near(low, high, [&](const OutlineSegment& s) {
      const auto [first, last] = covered_by(s, from, to, reach, slack_mm);
      if (first < last) covered.push_back({first, last});
    });
  });
  std::sort(covered.begin(), covered.end());
  double end = 0;
  for (const auto& [first, last] : covered) {
    if (first > end) left.push_back({end, first});
    end = std::max(end, last);
  }
  if (end < 1) left.push_back({end, 1});
  return left;
}

}  // namespace ligne
