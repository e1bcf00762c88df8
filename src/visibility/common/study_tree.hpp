#pragma once
/// From a tree that gives the pieces of a scene from the front to the back for any viewpoint to strokes and an order of
/// painting.

#include <utility>
#include <vector>

#include "visibility/common/clock.hpp"
#include "visibility/common/paint_pieces.hpp"
#include "visibility/common/study_edges.hpp"

namespace ligne {

/// `Tree` has pieces() and front_to_back(viewpoint, visit(piece, rank)), where pieces of one rank do not hide each other.
template <class Tree>
VisibilityResult study_tree(const Tree& tree, const ProjectedScene& scene, const StudyOptions& options) {
  Clock clock;
  FaceRanks ranks(scene.model->faces.size());
  std::vector<std::uint32_t> front_to_back;
  const bool paint = options.wanted & kOrder;
  tree.front_to_back(viewpoint_of(scene.view.camera), [&](std::uint32_t piece, std::uint32_t rank) {
    ranks.add(tree.pieces().face(piece), rank);
    if (paint) front_to_back.push_back(piece);
  });
  PaintOrder order;
  PaintPieces pieces(scene, tree.pieces());
  for (auto piece = front_to_back.rbegin(); piece != front_to_back.rend(); ++piece) pieces.add(*piece, order);
  std::vector<std::vector<Point2>> cut;
  if (options.settings.find("show")) cut = pieces.outlines_of_cut();
  const double seconds = clock.lap();

  VisibilityResult result = study_edges(scene, options, &ranks);
  if (paint) result.order = std::move(order);
  result.debug = std::move(cut);
  auto& times = result.statistics.seconds;
  times.insert(times.begin(), {"order", seconds});
  return result;
}

}  // namespace ligne
