#pragma once
/// The visiting part of SegmentFinder.

#include <algorithm>
#include <cmath>

#include "contours/contour_junctions.hpp"

namespace ligne {

/// The cells of the rectangle round the segment; segments are short.
template <class Visit>
void SegmentFinder::for_cells(Point2 from, Point2 to, Visit visit) const {
  const auto index = [&](double mm) { return static_cast<std::int32_t>(std::floor(mm / cell_mm_)); };
  const std::int32_t x0 = index(std::min(from.x, to.x)), x1 = index(std::max(from.x, to.x));
  const std::int32_t y0 = index(std::min(from.y, to.y)), y1 = index(std::max(from.y, to.y));
  for (std::int32_t y = y0; y <= y1; ++y) {
    for (std::int32_t x = x0; x <= x1; ++x) {
      visit(KeyTable::key(x, y));
    }
  }
}

}  // namespace ligne
