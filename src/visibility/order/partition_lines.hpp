#pragma once
/// The planes of a spatial tree as lines on the page.

#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "drawing/result_models.hpp"
#include "view/projected_scene.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne {

/// A node of a tree. Nodes follow their parents in the list.
struct PartitionNode {
  ModelPlane plane;
  bool divides = true;  ///< true if the plane divides what lies below the node
  std::uint32_t parent = 0xffffffffu;
  bool in_front = false;  ///< in front of its parent's plane
};

/// The nodes of a tree with links to parents instead of children. Node needs `plane`, `front` and `back`; a missing child is
/// kNone. `divides(node)`: true if its plane divides what lies below it.
template <typename Node, typename Divides>
std::vector<PartitionNode> partition_nodes(const std::vector<Node>& nodes, Divides&& divides) {
  std::vector<PartitionNode> partition(nodes.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    partition[i].plane = nodes[i].plane;
    partition[i].divides = divides(nodes[i]);
    for (const bool front : {true, false}) {
      const std::uint32_t child = front ? nodes[i].front : nodes[i].back;
      if (child == kNone) continue;
      partition[child].parent = i;
      partition[child].in_front = front;
    }
  }
  return partition;
}

/// The planes of a tree projected to the page.
struct PartitionLines {
  std::vector<std::vector<Point2>> outlines;  ///< closed, page mm; an edge-on plane gives a line there and back
  std::vector<PageNumber> numbers;            ///< at the centre of each outline: index among the dividing nodes, from 1
};

/// Per dividing node: the part of its plane inside the scene's bounding box and on its own side of its ancestors' planes.
/// Parents have lower numbers.
PartitionLines partition_lines(const ProjectedScene& scene, std::span<const PartitionNode> nodes);

}  // namespace ligne
