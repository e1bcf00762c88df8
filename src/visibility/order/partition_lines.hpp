#pragma once
/// The planes of a tree over space, as lines on the page.

#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "drawing/result_models.hpp"
#include "view/projected_scene.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne {

/// A node of a tree, behind its parent in the list of nodes.
struct PartitionNode {
  ModelPlane plane;
  bool divides = true;  ///< what is below it is divided by its plane
  std::uint32_t parent = 0xffffffffu;
  bool in_front = false;  ///< in front of its parent's plane
};

/// The nodes of a tree, with their parents instead of their children. A node has `plane`, `front` and `back`; a child that
/// is not there has the number kNone. `divides(node)`: whether its plane divides what is below it.
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

/// Planes of a tree on the page.
struct PartitionLines {
  std::vector<std::vector<Point2>> outlines;  ///< closed, page mm; those seen edge on are lines there and back
  std::vector<PageNumber> numbers;            ///< in the middle of each outline: of its node among those that divide, from 1
};

/// Per dividing node the part of its plane that divides: inside the box round the scene, and on its own side of the planes
/// of the nodes above it. Parents have lower numbers.
PartitionLines partition_lines(const ProjectedScene& scene, std::span<const PartitionNode> nodes);

}  // namespace ligne
