#include "visibility/bsp/bsp.hpp"

// Phases: (1) build the tree, in model space, (2) walk through it once, from the front, (3) test every edge against the
// faces that have pieces in front of its own. See docs/methods/bsp.md.

namespace ligne {

const MethodTraits& BspMethod::traits() const {
  static const MethodTraits traits{
      "bsp",
      "a binary tree of the planes of faces, built once for all viewpoints; its traversal gives the order",
      kStrokes | kRegions | kOrder,
      true,
      true,
      "H. Fuchs, Z. Kedem, B. Naylor, On visible surface generation by a priori tree structures, 1980",
      MethodTraits{}.tolerance_mm,
      kTreeParameters,
      {},
      true,
      TransparencyMode::seen_through};
  return traits;
}

void BspMethod::count(const BspTree::Counts& counts, Statistics& statistics) const {
  statistics.count("nodes", counts.nodes);
  statistics.count("nodes whose plane contains no face", counts.free_planes);
}

}  // namespace ligne
