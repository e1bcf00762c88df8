#pragma once
/// Delaunay triangulation of points of a lattice.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

struct Delaunay {
  /// Counter-clockwise (from +x towards +y) triples of indices into the points.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// neighbours[t][k] lies beyond the side from corner k to the next one; kNone at the convex hull.
  std::vector<std::array<std::uint32_t, 3>> neighbours;
};

/// Triangulates the convex hull. Requires distinct points that ascend by morton_key() (geometry/morton.hpp), with
/// coordinates of at most kLatticeLimit. There are no triangles if all points lie on a line. All signs are exact; of
/// four points on a circle either diagonal may be chosen. Divide and conquer with edges in rings around their ends
/// [GuibasStolfi1985]. The parts are squares and halves of squares, not strips, so that few edges are made and removed
/// again [Dwyer1987]: O(n) for evenly distributed points, O(n log n) in all cases that the lattice can hold.
Delaunay triangulate_delaunay(std::span<const LatticePoint> points);

}  // namespace ligne
