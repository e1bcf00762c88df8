// Phases: (1) build the tree, in model space, (2) walk through it once, from the front, (3) test every edge against the
// faces that have pieces in front of its own. See docs/methods/bsp.md.

#include "visibility/bsp/bsp.hpp"

#include <algorithm>
#include <numeric>

#include "base/stop.hpp"
#include "files/bytes.hpp"

namespace ligne {

const MethodTraits& BspTree::traits() {
  static const MethodTraits traits{
      .name = "bsp",
      .summary = "a binary tree of the planes of faces, built once for all viewpoints; its traversal gives the order",
      .products = kStrokes | kRegions | kOrder,
      .paper = "H. Fuchs, Z. Kedem, B. Naylor, On visible surface generation by a priori tree structures, 1980",
      .parameters = kTreeParameters,
      .compiles = true,
      .transparency = TransparencyMode::seen_through};
  return traits;
}

void BspTree::report(Statistics& statistics) const {
  statistics.count("nodes", counts_.nodes);
  statistics.count("nodes whose plane contains no face", counts_.free_planes);
}

BspTree::BspTree(const Scene& scene, const PlaneChoice& options) : pieces_(scene) {
  counts_.triangles = pieces_.pieces().size();
  if (pieces_.pieces().empty()) return;
  Task all;
  all.pieces.resize(pieces_.pieces().size());
  std::iota(all.pieces.begin(), all.pieces.end(), 0u);
  // A list of waiting sets replaces recursion, as a tree may be as deep as the number of faces.
  std::vector<Task> open;
  open.push_back(std::move(all));
  while (!open.empty()) {
    check_stop();
    Task task = std::move(open.back());
    open.pop_back();
    divide(std::move(task), options, open);
  }
}

BspTree::BspTree(ByteReader& bytes, const Scene& scene) : pieces_(bytes, scene) {
  for (std::uint64_t* count : {&counts_.triangles, &counts_.nodes, &counts_.splits, &counts_.depth, &counts_.free_planes}) {
    *count = bytes.number<std::uint64_t>();
  }
  nodes_ = bytes.list<Node>();
  in_planes_ = bytes.list<std::uint32_t>();
  // A valid tree is as compiled: the nodes own consecutive ranges.
  std::uint32_t end = 0;
  for (const Node& node : nodes_) {
    bytes.need(node.begin == end && node.begin <= node.end && node.end <= in_planes_.size(), "a node has no pieces");
    end = node.end;
    bytes.need(node.plane.is_finite(), "a plane is not finite");
  }
  require_tree(bytes, nodes_);
  bytes.need(end == in_planes_.size() && in_planes_.size() == pieces_.pieces().size(), "a piece is in no node");
  std::vector<std::uint8_t> is_there(in_planes_.size(), 0);
  for (const std::uint32_t piece : in_planes_) {
    bytes.need(piece < is_there.size() && !is_there[piece], "a piece is in two nodes");
    is_there[piece] = 1;
  }
}

void BspTree::write(ByteWriter& bytes) const {
  pieces_.write(bytes);
  for (const std::uint64_t count : {counts_.triangles, counts_.nodes, counts_.splits, counts_.depth, counts_.free_planes}) {
    bytes.number(count);
  }
  bytes.list(std::span<const Node>(nodes_));
  bytes.list(std::span<const std::uint32_t>(in_planes_));
}

void BspTree::divide(Task task, const PlaneChoice& options, std::vector<Task>& open) {
  const DividingPlane root = choose_plane(pieces_, task.pieces, options, task.seed);
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  if (task.parent != kNone) (task.front ? nodes_[task.parent].front : nodes_[task.parent].back) = number;
  Node node{.plane = root.plane, .begin = static_cast<std::uint32_t>(in_planes_.size())};
  Task front{{}, number, true, task.depth + 1, scramble(task.seed)};
  Task back{{}, number, false, task.depth + 1, scramble(task.seed + 1)};
  for (const std::uint32_t piece : task.pieces) {
    // The triangles of one face lie in one plane, but for the error of its corners: none hides another.
    const PlaneSide side = pieces_.face(piece) == root.face ? PlaneSide::on : pieces_.side(piece, root.plane);
    switch (side) {
      case PlaneSide::on:
        in_planes_.push_back(piece);
        break;
      case PlaneSide::front:
        front.pieces.push_back(piece);
        break;
      case PlaneSide::back:
        back.pieces.push_back(piece);
        break;
      case PlaneSide::both:
        back.pieces.push_back(pieces_.cut(piece, root.plane));
        front.pieces.push_back(piece);
        ++counts_.splits;
    }
  }
  node.end = static_cast<std::uint32_t>(in_planes_.size());
  nodes_.push_back(node);
  ++counts_.nodes;
  counts_.free_planes += root.face == kNone;
  counts_.depth = std::max(counts_.depth, task.depth);
  if (!back.pieces.empty()) open.push_back(std::move(back));
  if (!front.pieces.empty()) open.push_back(std::move(front));
}

std::vector<PartitionNode> BspTree::partition() const {
  return partition_nodes(nodes_, [](const Node&) { return true; });
}

}  // namespace ligne
