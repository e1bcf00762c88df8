#pragma once
/// The clip of the classical study: the general one, or that of convex contours where both are convex.

#include <span>
#include <vector>

#include "geometry/polygons/convex_clip.hpp"
#include "visibility/atherton_weiler/polygon_options.hpp"

namespace ligne::atherton_weiler {

/// Clips one subject after the other. One per task: it keeps its working memory.
class PolygonClip {
 public:
  PolygonClip(ClipKind kind, PolygonCounts& counts) : kind_(kind), counts_(counts) {}

  /// Divides the faces of the subject by the union of the clip faces. The faces of either do not overlap each other. Returns
  /// whether some of the subject is inside. `subject` must live until take_outside().
  bool divide(std::span<const ContourFace> subject, std::span<const ContourFace> clip);

  /// The parts found by divide(), once each; see clip_contour_by_contour(). Faces known to be convex are marked.
  std::vector<ContourFace> take_inside() { return std::move(inside_); }
  std::vector<ContourFace> take_outside();

 private:
  void divide_general(std::span<const ContourFace> subject, std::span<const ContourFace> clip);
  void divide_convex(const ContourFace& subject, const ContourFace& clip);

  ClipKind kind_;
  PolygonCounts& counts_;
  ConvexClip convex_;
  std::vector<ContourFace> inside_, outside_;
  std::vector<const ContourFace*> untouched_;  ///< faces of the subject that lie apart from the clip face
  std::vector<ContourFace> rest_;              ///< faces of the subject for the general clip
};

}  // namespace ligne::atherton_weiler
