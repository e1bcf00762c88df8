#pragma once
/// Binary space-partitioning: a tree of the faces, built once for any viewpoint, gives their order.
///
/// After H. Fuchs, Z. Kedem, B. Naylor, "On visible surface generation by a priori tree structures", SIGGRAPH 1980.
/// docs/methods/bsp.md.

#include <cstdint>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/method.hpp"
#include "visibility/order/model_pieces.hpp"
#include "visibility/order/partition_lines.hpp"
#include "visibility/order/tree_visibility.hpp"

namespace ligne {

/// The tree. Invariants: the pieces of a node lie in its plane, the pieces of its front subtree in front of the plane or on
/// it, the pieces of its back subtree behind it or on it; all within ModelPieces::tolerance(). Pieces of one face do not
/// overlap, and together they are the face.
class BspTree final : public CompiledScene {
 public:
  struct Counts {
    std::uint64_t triangles = 0;  ///< triangles of the scene with area
    std::uint64_t nodes = 0;
    std::uint64_t splits = 0;
    std::uint64_t depth = 0;        ///< nodes on the path from the root to the deepest node, both included
    std::uint64_t free_planes = 0;  ///< nodes whose plane is not the plane of a face
  };

  /// Compiles the scene. Typical time n log n in the number of faces; memory grows with the number of pieces, for any
  /// input.
  BspTree(const Scene& scene, const PlaneChoice& options);
  /// Reads a tree of the scene. Throws InputError.
  BspTree(ByteReader& bytes, const Scene& scene);
  void write(ByteWriter& bytes) const override;

  static const MethodTraits& traits();
  /// Reports the counts of this kind of tree alone.
  void report(Statistics& statistics) const;
  const ModelPieces& pieces() const { return pieces_; }
  const Counts& counts() const { return counts_; }

  /// The planes of the tree, node by node.
  std::vector<PartitionNode> partition() const;

  /// Calls visit(piece, rank) for all pieces from front to back. Pieces of one node lie in one plane and share a rank:
  /// none hides another.
  template <class Visit>
  void front_to_back(const Viewpoint& viewpoint, Visit visit) const {
    std::vector<std::pair<std::uint32_t, bool>> open;  // a node, and whether its own pieces are next
    std::uint32_t rank = 0;
    if (!nodes_.empty()) open.emplace_back(0, false);
    while (!open.empty()) {
      const auto [number, own_turn] = open.back();
      open.pop_back();
      const Node& node = nodes_[number];
      if (own_turn) {
        for (std::uint32_t i = node.begin; i < node.end; ++i) visit(in_planes_[i], rank);
        ++rank;
        continue;
      }
      const bool front = viewpoint.in_front_of(node.plane);
      const std::uint32_t near = front ? node.front : node.back, far = front ? node.back : node.front;
      if (far != kNone) open.emplace_back(far, false);
      open.emplace_back(number, true);
      if (near != kNone) open.emplace_back(near, false);
    }
  }

 private:
  struct Node {
    ModelPlane plane{};
    std::uint32_t begin = 0, end = 0;  ///< its pieces in in_planes_
    std::uint32_t front = kNone, back = kNone;
  };

  /// A set of pieces that becomes a subtree.
  struct Task {
    std::vector<std::uint32_t> pieces{};
    std::uint32_t parent = kNone;
    bool front = false;
    std::uint64_t depth = 1, seed = 0;
  };

  void divide(Task task, const PlaneChoice& options, std::vector<Task>& open);

  ModelPieces pieces_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> in_planes_;
  Counts counts_;
};

using BspMethod = TreeMethod<BspTree>;

}  // namespace ligne
