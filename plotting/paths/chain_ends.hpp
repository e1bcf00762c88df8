#pragma once
/// Loose ends of polylines, joined where they are near.

#include "drawing/drawing.hpp"

namespace ligne {

/// Polylines whose ends lie within the tolerance of each other become one, the nearest first, by a straight piece from end
/// to end; the two ends of one polyline make it closed when it is longer than `kLoopLengths` gaps. Closed polylines stay as
/// they are. Order: by the first polyline of each.
Polylines join_near_ends(const Polylines& lines, double tolerance_mm);

/// A line is closed over a gap only when it is so many times as long: it must go somewhere and come back.
inline constexpr double kLoopLengths = 4;

}  // namespace ligne
