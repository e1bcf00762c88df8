#pragma once
/// Binary space-partitioning: a tree of the faces, built once for any viewpoint, gives their order.
///
/// After H. Fuchs, Z. Kedem, B. Naylor, "On visible surface generation by a priori tree structures", SIGGRAPH 1980.
/// docs/methods/bsp.md.

#include "visibility/bsp/bsp_tree.hpp"
#include "visibility/order/tree_visibility.hpp"

namespace ligne {

class BspMethod final : public TreeMethod<BspTree> {
 public:
  const MethodTraits& traits() const override;

 private:
  void count(const BspTree::Counts& counts, Statistics& statistics) const override;
};

}  // namespace ligne
