#pragma once
/// Links contours that touch into loops that do not run along each other.

#include <cstdint>
#include <vector>

#include "geometry/point.hpp"
#include "geometry/polygons/contour_sweep.hpp"

namespace ligne {

/// The boundary of a polygon as loops with the inside on their left (x right, y up).
///
/// Invariants, for contours that do not cross: no two edges coincide, no vertex lies inside an edge, and a vertex that
/// several loops or several runs of a loop share separates the inside there. So a loop that lies inside another one shares
/// no point with it.
struct LinkedContours {
  std::vector<std::vector<std::uint32_t>> outer;  ///< loops of positions, counter-clockwise
  std::vector<std::vector<std::uint32_t>> holes;  ///< loops of positions, clockwise
};

/// Links `positions` as numbered by number_contour_edges() and `pieces`, the edges cut at every position on them.
/// Pieces along which two contours run in opposite directions bound nothing and vanish, and so do spikes and contours
/// without area.
LinkedContours link_contours(const std::vector<Point2>& positions, const std::vector<SweepEdge>& pieces);

}  // namespace ligne
