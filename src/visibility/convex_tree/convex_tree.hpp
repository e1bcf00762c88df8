#pragma once
/// Huet's display tree: nested convex sets of triangles, and planes that separate sets that are not convex. It is
/// compiled once; display needs only dot products.
///
/// S. Huet, "Compilation d'objets 3D", 1994. docs/methods/convex-tree.md.

#include <cstdint>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/method.hpp"
#include "visibility/order/model_pieces.hpp"
#include "visibility/order/partition_lines.hpp"
#include "visibility/order/tree_visibility.hpp"

namespace ligne {

/// Invariants: for every piece of a convex node, all other pieces of the node and of its subtree lie on one side of its
/// plane, the inside, or in the plane. The front subtree of a separating node lies in front of its plane or in it, the
/// back subtree behind it or in it. All within ModelPieces::tolerance().
class ConvexTree final : public CompiledScene {
 public:
  struct Counts {
    std::uint64_t triangles = 0;    ///< triangles of the scene with area
    std::uint64_t convex_sets = 0;  ///< nodes of type 1
    std::uint64_t planes = 0;       ///< nodes of type 2: the complexity of the tree
    std::uint64_t free_planes = 0;  ///< nodes of type 2 whose plane is not the plane of a triangle
    std::uint64_t splits = 0;
    std::uint64_t depth = 0;
    bool terminates = true;  ///< the measure of termination fell at every node
  };

  ConvexTree(const Scene& scene, const PlaneChoice& options);
  /// Reads a tree of the scene. Throws InputError.
  ConvexTree(ByteReader& bytes, const Scene& scene);
  void write(ByteWriter& bytes) const override;

  static const MethodTraits& traits();
  /// Reports the counts of this kind of tree alone.
  void report(Statistics& statistics) const;
  const ModelPieces& pieces() const { return pieces_; }
  const Counts& counts() const { return counts_; }

  /// The separating planes of the tree, with convex sets as nodes that divide nothing.
  std::vector<PartitionNode> partition() const;

  /// Calls visit(piece, rank) for all pieces from front to back. Pieces of one rank do not hide each other: they belong
  /// to one convex set, and all or none of them face the viewer.
  template <class Visit>
  void front_to_back(const Viewpoint& viewpoint, Visit visit) const {
    // A node, and whether only the far side of a convex set is left to visit.
    std::vector<std::pair<std::uint32_t, bool>> open;
    std::uint32_t rank = 0;
    if (!nodes_.empty()) open.emplace_back(0, false);
    while (!open.empty()) {
      const auto [number, far_side] = open.back();
      open.pop_back();
      const Node& node = nodes_[number];
      if (node.convex) {
        // Proposition 2: pieces seen from outside lie in front of everything inside the set, pieces seen from inside
        // behind it.
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
    std::uint32_t begin = 0, end = 0;           ///< convex set: range of inward_
    ModelPlane plane;                           ///< separating plane
    std::uint32_t front = kNone, back = kNone;  ///< `front` of a convex set is the subtree inside it
  };
  struct Task {
    std::vector<std::uint32_t> pieces{};
    std::uint32_t parent = kNone;
    bool front = true;
    std::uint64_t depth = 1, seed = 0;
    std::uint64_t most_supports = ~std::uint64_t{0};  ///< the rest after peeling off a convex set must have fewer
                                                      ///< supports
    bool lies_on_parent = false;                      ///< some pieces lie in the plane of the parent; they belong to a
                                                      ///< convex set
  };

  void compile(Task task, const PlaneChoice& options, std::vector<Task>& open);
  void peel(Task& task, Node& node);
  void separate(Task task, Node& node, const PlaneChoice& options, std::vector<Task>& open);
  bool should_peel(const std::vector<std::uint32_t>& set) const;
  std::uint64_t count_supports(const std::vector<std::uint32_t>& set);

  ModelPieces pieces_;
  std::vector<Node> nodes_;
  std::vector<Inward> inward_;
  Counts counts_;
  std::vector<std::uint64_t> counted_;  ///< per triangle: number of the last set that counted it
  std::uint64_t counted_sets_ = 0;
};

/// Convex sets and separating planes: a display tree, compiled once, gives the order of the faces from any viewpoint.
///
/// After S. Huet, "Compilation d'objets 3D", 1994. docs/methods/convex-tree.md.
using ConvexTreeMethod = TreeMethod<ConvexTree>;

}  // namespace ligne
