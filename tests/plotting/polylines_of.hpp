#pragma once
/// Polylines from lists of points, and their length.

#include <vector>

#include "drawing/drawing.hpp"
#include "plotting/paths/optimize.hpp"

namespace ligne::test {

inline Polylines polylines_of(const std::vector<std::vector<Point2>>& lists) {
  Polylines lines;
  for (const auto& list : lists) {
    lines.points.insert(lines.points.end(), list.begin(), list.end());
    lines.begin.push_back(static_cast<std::uint32_t>(lines.points.size()));
  }
  return lines;
}

inline double total_length(const Polylines& lines) { return measure(lines, {0, 0}, false).down_mm; }

}  // namespace ligne::test
