#include "visibility/bsp/bsp.hpp"

#include "visibility/common/clock.hpp"
#include "visibility/common/study_tree.hpp"

// Phases: (1) the tree, in model space, (2) one walk through it, from the front, (3) every edge against the faces that have
// pieces before its own. See docs/methods/bsp.md.

namespace ligne {
namespace {

constexpr unsigned kMostCandidates = 64;
constexpr std::string_view kPartitions[] = {"mixed", "faces"};
constexpr std::string_view kShowNames[] = {"splits"};
constexpr MethodParameter kParameters[] = {
    {"candidates",
     "K",
     "faces that are tried at random to divide a set; that of the fewest splits is taken",
     "5",
     {},
     1,
     kMostCandidates},
    {"partition", "HOW", "sets of many faces are divided by planes of no face too, or by planes of faces only", "mixed",
     kPartitions},
    {"show", "splits", "the pieces of faces that were cut, as layer debug", "", kShowNames},
};

}  // namespace

const MethodTraits& BspMethod::traits() const {
  static const MethodTraits traits{
      "bsp",
      "a tree of the faces, each in the plane of one, built once for any viewpoint; a walk through it gives their order",
      kStrokes | kOrder,
      true,
      true,
      "H. Fuchs, Z. Kedem, B. Naylor, On visible surface generation by a priori tree structures, 1980",
      MethodTraits{}.tolerance_mm,
      kParameters};
  return traits;
}

VisibilityResult BspMethod::study(const ProjectedScene& scene, const StudyOptions& options) const {
  Clock clock;
  BspOptions of_tree;
  of_tree.candidates = options.settings.find("candidates").value_or(of_tree.candidates);
  of_tree.free_planes = options.settings.find("partition").value_or(0) == 0;
  const BspTree tree(*scene.model, of_tree);
  const double seconds = clock.lap();
  VisibilityResult result = study(tree, scene, options);
  auto& times = result.statistics.seconds;
  times.insert(times.begin(), {"tree", seconds});
  return result;
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
