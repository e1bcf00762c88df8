#pragma once
/// Convex sets and separating planes: a display tree, compiled once, gives the order of the faces from any viewpoint.
///
/// After S. Huet, "Compilation d'objets 3D", 1994. docs/methods/convex-tree.md.

#include "visibility/convex_tree/convex_tree.hpp"
#include "visibility/order/tree_visibility.hpp"

namespace ligne {

class ConvexTreeMethod final : public TreeMethod<ConvexTree> {
 public:
  const MethodTraits& traits() const override;

 private:
  void count(const ConvexTree::Counts& counts, Statistics& statistics) const override;
};

}  // namespace ligne
