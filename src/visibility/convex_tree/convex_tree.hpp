#pragma once
/// Huet's display tree: convex sets of triangles, one inside the other, and planes between what is not convex. It is
/// compiled once; the display takes dot products only.
///
/// S. Huet, "Compilation d'objets 3D", 1994. docs/methods/convex-tree.md.

#include <cstdint>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/method.hpp"
#include "visibility/order/dividing_plane.hpp"
#include "visibility/order/model_pieces.hpp"
#include "visibility/order/partition_lines.hpp"

namespace ligne {

/// Invariants: every piece of a convex node has all other pieces of it and all those below on one side, the inside, or in
/// its plane; a separating node has its front subtree in front of its plane or in it, its back subtree behind it or in it.
/// Each within ModelPieces::tolerance().
class ConvexTree final : public CompiledScene {
 public:
  struct Counts {
    std::uint64_t triangles = 0;    ///< of the scene, with area
    std::uint64_t convex_sets = 0;  ///< nodes of type 1
    std::uint64_t planes = 0;       ///< nodes of type 2: the complexity of the tree
    std::uint64_t free_planes = 0;  ///< of them, those whose plane is that of no triangle
    std::uint64_t splits = 0;
    std::uint64_t depth = 0;
    bool terminates = true;  ///< the measure fell at every node
  };

  ConvexTree(const Scene& scene, const PlaneChoice& options);
  /// A tree of that scene that was written. Throws InputError.
  ConvexTree(ByteReader& bytes, const Scene& scene);
  void write(ByteWriter& bytes) const override;

  const ModelPieces& pieces() const { return pieces_; }
  const Counts& counts() const { return counts_; }

  /// Its separating planes, and its convex sets as nodes that divide nothing.
  std::vector<PartitionNode> partition() const;

  /// Calls visit(piece, rank) for all pieces from the front to the back. Pieces of one rank do not hide each other: they
  /// belong to one convex set, and all look at the viewer, or all look away.
  template <class Visit>
  void front_to_back(const Viewpoint& viewpoint, Visit visit) const {
    // A node, and what of it is to be done: all, or the far side of a convex set.
    std::vector<std::pair<std::uint32_t, bool>> open;
    std::uint32_t rank = 0;
    if (!nodes_.empty()) open.emplace_back(0, false);
    while (!open.empty()) {
      const auto [number, far_side] = open.back();
      open.pop_back();
      const Node& node = nodes_[number];
      if (node.convex) {
        // Proposition 2: what is seen from outside lies before all that is inside, what is seen from inside behind it.
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
          if (viewpoint.in_front_of(inward_[i].plane) == far_side) visit(inward_[i].piece, rank);
        }
        ++rank;
        if (far_side) continue;
        open.emplace_back(number, true);
        if (node.front != kNone) open.emplace_back(node.front, false);
        continue;
      }
      const bool front = viewpoint.in_front_of(node.plane);
      const std::uint32_t near = front ? node.front : node.back, far = front ? node.back : node.front;
      if (far != kNone) open.emplace_back(far, false);
      if (near != kNone) open.emplace_back(near, false);
    }
  }

 private:
  /// A piece of a convex set, and its plane with the normal to the inside.
  struct Inward {
    std::uint32_t piece;
    ModelPlane plane;
  };
  struct Node {
    bool convex = false;
    std::uint32_t begin = 0, end = 0;           ///< convex set: of inward_
    ModelPlane plane;                           ///< separating plane
    std::uint32_t front = kNone, back = kNone;  ///< of a convex set `front` is what is inside
  };
  struct Task {
    std::vector<std::uint32_t> pieces;
    std::uint32_t parent = kNone;
    bool front = true;
    std::uint64_t depth = 1, seed = 0;
    std::uint64_t most_supports = ~std::uint64_t{0};  ///< what is left when a convex set is peeled off has fewer
    bool lies_on_parent = false;                      ///< its pieces in the plane of the parent are part of a convex set
  };

  void compile(Task task, const PlaneChoice& options, std::vector<Task>& open);
  void peel(Task& task, Node& node);
  void separate(Task task, Node& node, const PlaneChoice& options, std::vector<Task>& open);
  bool is_worth_peeling(const std::vector<std::uint32_t>& set) const;
  std::uint64_t count_supports(const std::vector<std::uint32_t>& set);

  ModelPieces pieces_;
  std::vector<Node> nodes_;
  std::vector<Inward> inward_;
  Counts counts_;
  std::vector<std::uint64_t> counted_;  ///< per triangle: the set for which it was counted last
  std::uint64_t counted_sets_ = 0;
};

}  // namespace ligne
