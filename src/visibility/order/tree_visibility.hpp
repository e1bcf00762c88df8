#pragma once
/// Strokes and a painting order from a tree that lists the pieces of a scene front to back for any viewpoint.

#include <memory>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "files/bytes.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/edges/edge_visibility.hpp"
#include "visibility/method.hpp"
#include "visibility/order/model_pieces.hpp"
#include "visibility/order/paint_pieces.hpp"
#include "visibility/order/partition_lines.hpp"

namespace ligne {

/// The parameters of methods that compile a tree.
inline constexpr unsigned kMostCandidates = 64;
enum class PartitionPlanes : std::uint8_t { mixed, faces };
inline constexpr std::string_view kPartitionNames[] = {"mixed", "faces"};
enum class TreeShow : std::uint8_t { splits, order, tree };
inline constexpr std::string_view kTreeShowNames[] = {"splits", "order", "tree"};
inline constexpr MethodParameter kTreeParameters[] = {
    experiment({"candidates",
                "K",
                "random faces tried as dividing planes of a set; the one with the fewest splits is taken",
                "5",
                {},
                1,
                kMostCandidates,
                true}),
    experiment({"partition", "HOW",
                "mixed: large sets may also be divided by planes that contain no face; faces: only by planes of faces",
                "mixed", kPartitionNames, 0, 0, true}),
    {"show", "splits|order|tree",
     "layer debug: the pieces of cut faces, the painting order as numbers, or the planes of the tree", "", kTreeShowNames},
};

inline PlaneChoice plane_choice(const MethodSettings& settings) {
  PlaneChoice choice;
  choice.candidates = settings.count("candidates").value_or(choice.candidates);
  choice.free_planes = settings.choice("partition", PartitionPlanes::mixed) == PartitionPlanes::mixed;
  return choice;
}

/// `Tree` has pieces(), partition() and front_to_back(viewpoint, visit(piece, rank)). Pieces of one rank do not hide each
/// other.
template <class Tree>
VisibilityResult tree_visibility(const Tree& tree, const ProjectedScene& scene, const VisibilityOptions& options) {
  Clock clock;
  FaceRanks ranks(scene.model->faces.size());
  std::vector<std::uint32_t> front_to_back;
  const bool shows = options.settings.has("show");
  const TreeShow show = options.settings.choice("show", TreeShow::splits);
  const bool paint = (options.wanted & kOrder) || (shows && show == TreeShow::order);
  tree.front_to_back(viewpoint_of(scene.view.camera), [&](std::uint32_t piece, std::uint32_t rank) {
    ranks.add(tree.pieces().face(piece), rank);
    if (paint) front_to_back.push_back(piece);
  });
  PaintOrder order;
  PaintPieces pieces(scene, tree.pieces());
  for (auto piece = front_to_back.rbegin(); piece != front_to_back.rend(); ++piece) pieces.add(*piece, order);
  std::vector<std::vector<Point2>> shown;
  if (shows && show == TreeShow::splits) shown = pieces.outlines_of_cut();
  PartitionLines planes;
  if (shows && show == TreeShow::tree) planes = partition_lines(scene, tree.partition());
  const double seconds = clock.lap();

  VisibilityResult result = edge_visibility(scene, options, &ranks);
  if (shows && show == TreeShow::order) result.debug_numbers = order_numbers(order);
  if (options.wanted & kOrder) result.order = std::move(order);
  result.debug = std::move(shown);
  if (shows && show == TreeShow::tree) {
    result.debug = std::move(planes.outlines);
    result.debug_numbers = std::move(planes.numbers);
  }
  auto& times = result.statistics.seconds;
  times.insert(times.begin(), {"order", seconds});
  return result;
}

/// Throws InputError unless the nodes of a tree that was read are as compiled: each stands before its subtrees, and in one.
template <class Node>
void require_tree(const ByteReader& bytes, const std::vector<Node>& nodes) {
  std::vector<std::uint8_t> is_child(nodes.size(), 0);
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    for (const std::uint32_t child : {nodes[i].front, nodes[i].back}) {
      if (child == kNone) continue;
      bytes.need(child > i && child < nodes.size() && !is_child[child], "a subtree is missing or repeated");
      is_child[child] = 1;
    }
  }
}

/// A method that compiles a tree from a scene's model once, for all views. `Tree` has traits(), and report(statistics) for
/// its own counts.
template <class Tree>
class TreeMethod final : public Method {
 public:
  const MethodTraits& traits() const override { return Tree::traits(); }

  /// Uses the compiled tree if there is one; otherwise compiles it and reports the time before those of the study.
  VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const final {
    if (options.compiled) return compute_visibility(dynamic_cast<const Tree&>(*options.compiled), scene, options);
    Clock clock;
    const Tree tree(*scene.model, plane_choice(options.settings));
    const double seconds = clock.lap();
    VisibilityResult result = compute_visibility(tree, scene, options);
    auto& times = result.statistics.seconds;
    times.insert(times.begin(), {"tree", seconds});
    return result;
  }
  std::shared_ptr<const CompiledScene> compile(const Scene& scene, const MethodSettings& settings) const final {
    return std::make_shared<Tree>(scene, plane_choice(settings));
  }
  std::shared_ptr<const CompiledScene> read_compiled(ByteReader& bytes, const Scene& scene) const final {
    return std::make_shared<Tree>(bytes, scene);
  }

  /// Uses a tree built earlier from the scene's model, for this or another view.
  VisibilityResult compute_visibility(const Tree& tree, const ProjectedScene& scene,
                                      const VisibilityOptions& options) const {
    VisibilityResult result = tree_visibility(tree, scene, options);
    tree.report(result.statistics);
    result.statistics.count("splits", tree.counts().splits);
    result.statistics.count("pieces", tree.pieces().pieces().size());
    result.statistics.count("depth of the tree", tree.counts().depth);
    return result;
  }
};

}  // namespace ligne
