#include "visibility/bsp/bsp.hpp"

#include "visibility/common/study_tree.hpp"

// Phases: (1) the tree, in model space, (2) one walk through it, from the front, (3) every edge against the faces that have
// pieces before its own. See docs/methods/bsp.md.

namespace ligne {

const MethodTraits& BspMethod::traits() const {
  static const MethodTraits traits{
      "bsp",
      "a tree of the faces, each in the plane of one, built once for any viewpoint; a walk through it gives their order",
      kStrokes | kRegions | kOrder,
      true,
      true,
      "H. Fuchs, Z. Kedem, B. Naylor, On visible surface generation by a priori tree structures, 1980",
      MethodTraits{}.tolerance_mm,
      kTreeParameters,
      {},
      true,
      Glass::seen_through};
  return traits;
}

VisibilityResult BspMethod::study(const ProjectedScene& scene, const StudyOptions& options) const {
  return compile_and_study<BspTree>(scene, options, [&](const BspTree& tree) { return study(tree, scene, options); });
}

std::shared_ptr<const CompiledScene> BspMethod::compile(const Scene& scene, const MethodSettings& settings) const {
  return std::make_shared<BspTree>(scene, plane_choice(settings));
}

std::shared_ptr<const CompiledScene> BspMethod::read_compiled(ByteReader& bytes, const Scene& scene) const {
  return std::make_shared<BspTree>(bytes, scene);
}

VisibilityResult BspMethod::study(const BspTree& tree, const ProjectedScene& scene, const StudyOptions& options) {
  VisibilityResult result = study_tree(tree, scene, options);
  Statistics& statistics = result.statistics;
  const BspTree::Counts& counts = tree.counts();
  statistics.count("nodes", counts.nodes);
  statistics.count("nodes in planes of no face", counts.free_planes);
  statistics.count("splits", counts.splits);
  statistics.count("pieces", tree.pieces().pieces().size());
  statistics.count("depth of the tree", counts.depth);
  return result;
}

}  // namespace ligne
