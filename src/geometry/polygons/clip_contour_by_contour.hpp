#pragma once
/// A face clipped by a face: the elementary operation of Atherton and Weiler.
///
/// P. Atherton, K. Weiler, "Hidden surface removal using polygon area sorting", SIGGRAPH 1977; contours of any form,
/// with holes. The paper walks along a contour and changes to the other one at each intersection. Where corners lie on
/// edges or edges on edges, that walk needs special cases. Here every edge of both faces is first cut into parts whose
/// two sides are uniform. A part belongs to the border of a result if the result lies on exactly one of its sides. The
/// parts found are then linked. See geometry/polygons/edge_overlay.hpp for the singular cases.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygons/contour_face.hpp"

namespace ligne {

struct ClipResult {
  std::vector<ContourFace> inside, outside;  ///< of the subject, inside and outside the clip face
};

/// Clips the subject face by the clip face. Either may be any set of faces; faces of one set that overlap count once.
///
/// Identities: inside and outside have no inner point in common and together are the subject; clip(a, b).inside and clip(b,
/// a).inside cover the same points; clip(a, a) gives a and nothing. Corners that the results have in common have the same
/// coordinates. Exact for source segments with |coordinates| <= kLatticeLimit. Time: the product of the numbers of edges.
/// `closed`: see link_edges(). It is needed for results that are clipped again, if the faces of each list are kept
/// together. Of coincident edges, those of the subject are then kept. `signs`: the number of signs of corners against lines
/// is added to it.
ClipResult clip_contour_by_contour(std::span<const ContourFace> subject, std::span<const ContourFace> clip,
                                   bool closed = false, std::uint64_t* signs = nullptr);

/// Whether two sets of faces have inner points in common. Exact, also for overlaps that the fine lattice does not show.
/// Time: at most that of the clip; the search ends at the first common point. `signs`: see clip_contour_by_contour().
bool contours_overlap(std::span<const ContourFace> a, std::span<const ContourFace> b, std::uint64_t& signs);

inline ClipResult clip_contour_by_contour(const ContourFace& subject, const ContourFace& clip) {
  return clip_contour_by_contour(std::span(&subject, 1), std::span(&clip, 1));
}

}  // namespace ligne
