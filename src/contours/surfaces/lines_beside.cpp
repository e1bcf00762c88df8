#include "contours/surfaces/lines_beside.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/nearest_on_segment.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Least cosine of the angle between an edge and a line that runs beside it: 45 degrees.
constexpr double kBesideCosine = 0.70710678;

bool runs_along(Point2 a, Point2 b) { return std::abs(glm::dot(a, b)) >= kBesideCosine * glm::length(a) * glm::length(b); }

/// The part of from-to beside which a segment runs.
StrokePart covered_by(const OutlineSegment& s, Point2 from, Point2 to, double reach, double slack_mm) {
  const Point2 edge = to - from, d = s.to - s.from;
  const double length = glm::length(d);
  if (length == 0 || !runs_along(edge, d)) return {1, 0};
  const auto along = [&](Point2 p) { return glm::dot(p - s.from, d) / length; };
  const auto across = [&](Point2 p) { return (d.x * (p.y - s.from.y) - d.y * (p.x - s.from.x)) / length; };
  StrokePart covered{0, 1};
  covered.keep(along(from), along(to) - along(from), -slack_mm, length + slack_mm);
  covered.keep(across(from), across(to) - across(from), -reach, reach);
  return covered;
}

}  // namespace

bool LinesBeside::any_within(Point2 p, double reach) const {
  return finder_.any_near(p, p, reach,
                          [&](const OutlineSegment& s) { return squared_distance(p, s.from, s.to) <= reach * reach; });
}

std::optional<Point2> LinesBeside::crossing(Point2 p, Point2 direction, double reach) const {
  std::optional<Point2> best;
  finder_.near(p, p, reach, [&](const OutlineSegment& s) {
    const Point2 d = s.to - s.from;
    if (runs_along(d, direction)) return;
    const double along = cross(direction, p - s.from) / cross(direction, d);
    const Point2 q = s.from + along * d;
    const double away = glm::length(q - p);
    if (along >= 0 && along <= 1 && away <= reach && (!best || away < glm::length(*best - p))) best = q;
  });
  return best;
}

std::optional<Point2> LinesBeside::nearest_end(Point2 p, double reach) const {
  std::optional<Point2> best;
  const auto offer = [&](Point2 q) {
    const double d = glm::length(q - p);
    if (d <= reach && (!best || d < glm::length(*best - p))) best = q;
  };
  finder_.near(p, p, reach, [&](const OutlineSegment& s) {
    offer(s.from);
    offer(s.to);
  });
  return best;
}

std::vector<std::array<double, 2>> LinesBeside::uncovered(Point2 from, Point2 to, double reach, double slack_mm) const {
  std::vector<std::array<double, 2>> covered, left;
  finder_.near(from, to, reach, [&](const OutlineSegment& s) {
    const StrokePart part = covered_by(s, from, to, reach, slack_mm);
    if (part.from < part.to) covered.push_back({part.from, part.to});
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
