#include "visibility/convex_tree/convex_tree_method.hpp"

// Phases: (1) build the tree, in model space, (2) walk through it once, from the front, by dot products, (3) test every
// edge against the faces that have pieces in front of its own. See docs/methods/convex-tree.md.

namespace ligne {

const MethodTraits& ConvexTreeMethod::traits() const {
  static const MethodTraits traits{
      "convex-tree",
      "nested convex sets of triangles with separating planes, compiled once for all viewpoints",
      kStrokes | kRegions | kOrder,
      true,
      true,
      "S. Huet, Compilation d'objets 3D, 1994",
      MethodTraits{}.tolerance_mm,
      kTreeParameters,
      {},
      true,
      TransparencyMode::seen_through};
  return traits;
}

void ConvexTreeMethod::count(const ConvexTree::Counts& counts, Statistics& statistics) const {
  statistics.count("convex sets (nodes of type 1)", counts.convex_sets);
  statistics.count("complexity (nodes of type 2)", counts.planes);
  statistics.count("of these, planes that contain no face", counts.free_planes);
}

}  // namespace ligne
