#pragma once
/// Decides which edges of more than two faces are lines.

#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// An edge at which faces ("walls") stand on two faces that continue each other smoothly. The line is visible only from
/// the side of the walls.
struct WallEdge {
  std::uint32_t edge = 0;  ///< index in the topology
  Point3 side{0, 0, 0};    ///< unit normal of the two smooth faces, towards the side of the walls
};

/// A face at an edge of more than two that is no line. `normal` is a unit vector, turned as if all faces traversed the edge
/// in one direction: where the normals of all faces at an edge turn to one side, the sheets fold over there.
struct FoldSheet {
  std::uint32_t edge = 0;  ///< index in the topology
  Point3 normal{0, 0, 0};
};

struct SheetEdges {
  /// Per edge of more than two faces, in ascending order of these edges: 1 if it is a line. It is one if two of its
  /// faces leave it in directions that are neither equal nor opposite, or if all leave it in the same direction, so
  /// that the sheets end there.
  std::vector<std::uint8_t> bent;
  std::vector<WallEdge> walls;   ///< those of them that are wall edges, ascending
  std::vector<FoldSheet> folds;  ///< the faces at edges that are no lines, those of one edge after each other, ascending
};

/// Examines all edges of more than two faces. `crease_cosine`: cosine of the smallest angle of different directions.
/// O(n log n).
SheetEdges find_sheet_edges(const Scene& scene, const Topology& topology, float crease_cosine);

}  // namespace ligne
