#pragma once
/// The visiting part of SegmentFinder.

#include <algorithm>
#include <cmath>

#include "contours/contour_junctions.hpp"

namespace ligne {

inline SegmentFinder::Rectangle SegmentFinder::cells_round(Point2 from, Point2 to) const {
  const auto index = [&](double mm) { return static_cast<std::int32_t>(std::floor(mm / cell_mm_)); };
  return {index(std::min(from.x, to.x)), index(std::max(from.x, to.x)), index(std::min(from.y, to.y)),
          index(std::max(from.y, to.y))};
}

template <class Visit>
void SegmentFinder::for_cells(const Rectangle& cells, Visit visit) {
  for (std::int32_t y = cells.y0; y <= cells.y1; ++y) {
    for (std::int32_t x = cells.x0; x <= cells.x1; ++x) visit(KeyTable::key(x, y));
  }
}

}  // namespace ligne
