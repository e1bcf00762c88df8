#pragma once
/// Delaunay triangulation of points of a lattice.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

struct Delaunay {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// Counter-clockwise (from +x towards +y) triples of indices into the points.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// neighbours[t][k] lies beyond the side from corner k to the next one; kNone at the convex hull.
  std::vector<std::array<std::uint32_t, 3>> neighbours;
};

/// Triangulates the convex hull. Points are different, ascend by x and then by y, and have coordinates of at most
/// kLatticeLimit. There are no triangles when all points lie on a line. All signs are exact; of four points on a circle
/// either diagonal may be taken. Divide and conquer with edges in rings round their ends (Guibas and Stolfi 1985), O(n log
/// n).
Delaunay triangulate_delaunay(std::span<const LatticePoint> points);

}  // namespace ligne
