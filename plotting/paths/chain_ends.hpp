#pragma once
/// Joins loose ends of polylines that are near each other.

#include "drawing/drawing.hpp"

namespace ligne {

/// Joins polylines whose ends lie within the tolerance of each other by a straight segment, the nearest first. The two
/// ends of one polyline are joined only if it is longer than kLoopLengths gaps. Closed polylines stay as they are. The
/// results are ordered by the first polyline in each.
Polylines join_near_ends(const Polylines& lines, double tolerance_mm);

/// A line is closed over a gap only if it is longer than this multiple of the gap: it must go somewhere and come back.
inline constexpr double kLoopLengths = 4;

}  // namespace ligne
