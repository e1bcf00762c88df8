#include "visibility/convex_tree/convex_tree_method.hpp"

#include "visibility/common/study_tree.hpp"

// Phases: (1) the tree, in model space, (2) one walk through it, from the front, by dot products, (3) every edge against the
// faces that have pieces before its own. See docs/methods/convex-tree.md.

namespace ligne {

const MethodTraits& ConvexTreeMethod::traits() const {
  static const MethodTraits traits{
      "convex-tree",
      "convex sets of triangles, one inside the other, with planes between them, compiled once for any viewpoint",
      kStrokes | kRegions | kOrder,
      true,
      true,
      "S. Huet, Compilation d'objets 3D, 1994",
      MethodTraits{}.tolerance_mm,
      kTreeParameters,
      {},
      true,
      Glass::seen_through};
  return traits;
}

VisibilityResult ConvexTreeMethod::study(const ProjectedScene& scene, const StudyOptions& options) const {
  return compile_and_study<ConvexTree>(scene, options, [&](const ConvexTree& tree) { return study(tree, scene, options); });
}

std::shared_ptr<const CompiledScene> ConvexTreeMethod::compile(const Scene& scene, const MethodSettings& settings) const {
  return std::make_shared<ConvexTree>(scene, plane_choice(settings));
}

std::shared_ptr<const CompiledScene> ConvexTreeMethod::read_compiled(ByteReader& bytes, const Scene& scene) const {
  return std::make_shared<ConvexTree>(bytes, scene);
}

VisibilityResult ConvexTreeMethod::study(const ConvexTree& tree, const ProjectedScene& scene, const StudyOptions& options) {
  VisibilityResult result = study_tree(tree, scene, options);
  Statistics& statistics = result.statistics;
  const ConvexTree::Counts& counts = tree.counts();
  statistics.count("convex sets (nodes of type 1)", counts.convex_sets);
  statistics.count("complexity (nodes of type 2)", counts.planes);
  statistics.count("of them in planes of no face", counts.free_planes);
  statistics.count("splits", counts.splits);
  statistics.count("pieces", tree.pieces().pieces().size());
  statistics.count("depth of the tree", counts.depth);
  return result;
}

}  // namespace ligne
