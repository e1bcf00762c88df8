#pragma once
/// A face clipped by a face: the elementary operation of Atherton and Weiler.
///
/// P. Atherton, K. Weiler, "Hidden surface removal using polygon area sorting", SIGGRAPH 1977; contours of any form, with
/// holes. The papers walk from intersection to intersection and change over to the other contour there; where corners lie on
/// edges or edges on edges the walk needs cases, and each case a rule. Here nothing is walked before everything is known:
/// every edge of both faces is cut into parts on whose two sides nothing changes, a part belongs to the border of a result
/// when the result lies on one of its sides and not on the other, and the parts found are linked. See
/// geometry/polygons/edge_overlay.hpp for the singular cases.

#include <span>
#include <vector>

#include "geometry/polygons/contour_face.hpp"

namespace ligne {

struct ClipResult {
  std::vector<ContourFace> inside, outside;  ///< of the subject, inside and outside the clip face
};

/// Clips the subject face by the clip face. Either may be any set of faces, given as the faces of the other lists are; where
/// they overlap each other the set counts once.
///
/// Identities: inside and outside have no inner point in common and together are the subject; clip(a, b).inside and clip(b,
/// a).inside cover the same points; clip(a, a) gives a and nothing. Corners that the results have in common have the same
/// coordinates. Exact for source segments with |coordinates| <= kLatticeLimit. Time: the product of the numbers of edges.
/// `closed`: see link_edges(). Results that are clipped again are to be closed, and the faces of each list kept together. Of
/// edges that lie on each other those of the subject are then kept.
ClipResult clip_contour_by_contour(std::span<const ContourFace> subject, std::span<const ContourFace> clip,
                                   bool closed = false);

inline ClipResult clip_contour_by_contour(const ContourFace& subject, const ContourFace& clip) {
  return clip_contour_by_contour(std::span(&subject, 1), std::span(&clip, 1));
}

}  // namespace ligne
