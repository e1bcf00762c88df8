#pragma once
/// Lengths, distances and kinds of strokes on the page.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "linework/stroke.hpp"

namespace ligne {

/// True for strokes that are seen directly, not only through transparent faces.
inline bool is_seen(const Stroke& s) { return s.visible && s.level == 0; }

/// True for edges of the scene and intersections; false for lines of surfaces and axes, which no rule changes.
inline bool is_edge(const Stroke& s) { return static_cast<std::size_t>(s.line_class) < kEdgeClassCount; }

/// True for lines that rules join and extend: edges that are not mere mesh edges.
inline bool is_feature(const Stroke& s) { return is_edge(s) && s.line_class != LineClass::mesh; }

inline bool any_hidden(const std::vector<Stroke>& strokes) {
  return std::ranges::any_of(strokes, [](const Stroke& s) { return !s.visible; });
}

/// Length of a segment, lattice steps. The sum is exact on the lattice, and std::hypot() takes ten times as long.
inline double length(LatticePoint a, LatticePoint b) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// Length of a stroke on the page, lattice steps.
inline double page_length(const Stroke& s) { return length(s.from, s.to); }

/// The point at a fraction of a stroke's length, rounded to the lattice.
inline LatticePoint point_at(const Stroke& s, double fraction) {
  const auto between = [&](std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(std::lround(a + fraction * (double(b) - a)));
  };
  return {between(s.from.x, s.to.x), between(s.from.y, s.to.y)};
}

/// The point of a segment that is nearest to a given point.
struct FootPoint {
  double fraction = 0;  ///< of the segment's length, from 0 to 1
  double distance = 0;  ///< lattice steps
};
inline FootPoint foot_on(const Stroke& s, LatticePoint p) {
  const double dx = double(s.to.x) - s.from.x, dy = double(s.to.y) - s.from.y;
  const double px = double(p.x) - s.from.x, py = double(p.y) - s.from.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0;
  const double x = px - t * dx, y = py - t * dy;
  return {t, std::sqrt(x * x + y * y)};
}

}  // namespace ligne
