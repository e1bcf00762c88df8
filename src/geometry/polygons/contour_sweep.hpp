#pragma once
/// A sweep over the edges of contours: where they meet each other, and the triangles of what they bound.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// An edge of contours, from a position to one of higher number; or several that lie on each other.
struct SweepEdge {
  std::uint32_t low = 0, high = 0;
  /// How many more contours wind round what lies to the left of it than round what lies to the right: 1 for an edge of a
  /// contour that runs from low to high with the inside on its left, -1 for one that runs the other way.
  std::int32_t winding = 0;
};

struct SweptContours {
  /// No two edges cross, and no point is wound round but once or not at all.
  bool simple = true;
  /// The edges, cut at every position that lies on them. Equal ones are one piece; what cancels out is left out.
  std::vector<SweepEdge> pieces;
  /// When simple, what the contours wind round: triples of positions, counter-clockwise, none without area.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// `positions` are distinct and in lexicographic order; `edges` are edges of closed contours, and may cross, touch and lie
/// on each other. O(n log n) for contours that do not cross.
SweptContours sweep_contours(const std::vector<Point2>& positions, std::vector<SweepEdge> edges);

}  // namespace ligne
