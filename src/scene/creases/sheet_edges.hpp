#pragma once
/// Edges of more than two faces.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// An edge at which walls stand on two faces that run on into each other: it is seen from the side of the walls alone.
struct WallEdge {
  std::uint32_t edge = 0;  ///< of the topology
  Point3 side{0, 0, 0};    ///< unit vector to the side of the walls, square to the two faces
};

struct SheetEdges {
  /// Per edge of more than two faces, in their order, 1 where it is a line: the directions of two of its faces from it are
  /// neither alike nor opposite; or all are alike, and the sheets end there.
  std::vector<std::uint8_t> bent;
  std::vector<WallEdge> walls;  ///< some of these, in ascending order
};

/// `crease_cosine` is that of the angle by which directions differ. O(n log n).
SheetEdges find_sheet_edges(const Scene& scene, const Topology& topology, float crease_cosine);

}  // namespace ligne
