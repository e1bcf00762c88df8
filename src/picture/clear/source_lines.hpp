#pragma once
/// The candidates and the faces of the lines that strokes are parts of.

#include <array>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "linework/stroke.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// Keeps references to its arguments. O(n).
class SourceLines {
 public:
  SourceLines(const StrokeModel& model, const ProjectedScene& projected)
      : model_(model), projected_(projected), candidate_of_(model.edge_count, kNone) {
    for (std::uint32_t i = 0; i < projected.edges.size(); ++i) candidate_of_[projected.edges[i].source] = i;
  }

  /// The index of the candidate with a source; kNone if there is none.
  std::uint32_t candidate(std::uint32_t source) const {
    return source < candidate_of_.size() ? candidate_of_[source] : kNone;
  }
  /// The first two faces of the source of a stroke.
  std::array<std::uint32_t, 2> faces(const Stroke& stroke) const {
    if (stroke.source >= model_.edge_count) return model_.intersections[stroke.source - model_.edge_count].faces;
    const std::uint32_t i = candidate_of_[stroke.source];
    if (i == kNone) return {kNone, kNone};
    return {projected_.edges[i].face0, projected_.edges[i].face1};
  }

 private:
  const StrokeModel& model_;
  const ProjectedScene& projected_;
  std::vector<std::uint32_t> candidate_of_;  ///< by source
};

}  // namespace ligne
