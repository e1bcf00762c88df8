#pragma once
/// Contours that touch, made into loops that do not run along each other.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// The boundary of a polygon as loops with the inside on their left (x right, y up).
///
/// Invariants, for input contours that do not cross: no two edges coincide, no vertex lies inside an edge, and a vertex
/// that several loops or several runs of a loop share separates the inside there. So a loop that lies inside another one
/// shares no point with it.
struct LinkedContours {
  std::vector<Point2> positions;                  ///< distinct, in lexicographic order (x first)
  std::vector<std::uint32_t> source;              ///< per position: the lowest index of an input point there
  std::vector<std::vector<std::uint32_t>> outer;  ///< loops of positions, counter-clockwise
  std::vector<std::vector<std::uint32_t>> holes;  ///< loops of positions, clockwise
};

/// `points` and `contour_end` as in triangulate(). Contours may touch at corners and along edges; what two of them run
/// along in opposite directions belongs to neither boundary and vanishes, and so do spikes and contours without area.
LinkedContours link_contours(std::span<const Point2> points, std::span<const std::uint32_t> contour_end);

/// +1 when the closed contour has its inside on the left, -1 when on the right, 0 when it has no area.
int contour_sign(std::span<const Point2> contour);

}  // namespace ligne
