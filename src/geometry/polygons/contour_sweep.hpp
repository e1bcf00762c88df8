#pragma once
/// A sweep over the edges of contours: where they meet, and the triangles of the region that they bound.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// An edge of the contours, or several coincident ones, from one position to a later one.
struct SweepEdge {
  std::uint32_t low = 0, high = 0;
  /// Winding number of the contours on the left of the edge minus that on its right: 1 for an edge of a contour that
  /// runs from low to high with the inside on its left, -1 for one that runs the other way.
  std::int32_t winding = 0;
};

struct SweptContours {
  /// No two edges cross, and every winding number is 0 or 1.
  bool simple = true;
  /// The edges, cut at every position on them. Coincident pieces are merged, and dropped if their windings cancel out.
  std::vector<SweepEdge> pieces;
  /// If simple: triangles of the inside, as triples of positions, counter-clockwise, none without area.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// `positions` are distinct and in lexicographic order. `edges` are the edges of closed contours, which may cross,
/// touch and overlap. O(n log n) for contours that do not cross.
SweptContours sweep_contours(const std::vector<Point2>& positions, std::vector<SweepEdge> edges);

}  // namespace ligne
