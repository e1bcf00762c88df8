#pragma once
/// Triangulation of a planar contour with holes.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Cuts a polygon into triangles.
///
/// `points` are the corners of all contours, one contour after the other; `contour_end[i]` is one past the last corner of
/// contour i. The first contour is the outer one, the others are holes; either winding is accepted. Contours may touch
/// themselves and each other at corners and along edges.
///
/// Returns triples of indices into `points`, wound as the outer contour is. Triangles without area are left out. For
/// contours that cross, the triangles cover the polygon as well as they can; that is not an error. `whole`, if not null,
/// tells whether all was cut. If true, the number of triangles over a point is the winding number of the outer contour
/// less that of the holes, which is never negative, so the cover follows the nonzero rule. If false, a part wound the
/// other way, or a hole outside, was not cut. No triangle has a corner in the middle of a side, unless contours cross
/// or ear cutting finds no other triangle.
///
/// Method: polygons with few corners are cut by ears (ear_cutter.hpp). For others a sweep over the corners
/// (contour_sweep.hpp) finds where contours touch and cross, and cuts triangles as it advances (monotone_chains.hpp);
/// edges are then flipped to leave few slender triangles (flip_edges.hpp). O(n log n) for n corners, plus the flips,
/// whose number has a linear bound. Contours that cross, or that wind around a point more than once, are cut by ears at
/// any number of corners: O(n^2) as a rule.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Point2> points,
                                                      std::span<const std::uint32_t> contour_end, bool* whole = nullptr);

/// Returns `whole` as triangulate() does, in less time.
bool triangles_are_whole(std::span<const Point2> points, std::span<const std::uint32_t> contour_end);

}  // namespace ligne
