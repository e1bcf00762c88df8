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
/// Returns triples of indices into `points`, wound as the outer contour is. Triangles without area are left out. Contours
/// that cross give triangles that cover the polygon as well as they can; there is no error. `whole`, when not null, says
/// whether something was left: if true, a point lies in as many triangles as the outer contour winds round it, less the
/// holes that do, and never in a negative number (so what is covered is right by the nonzero rule); if false, a part wound
/// the other way round, or a hole outside, was not cut. No triangle has a corner in the middle of a side, unless contours
/// cross or no other triangles are left to the ears.
///
/// Method: few corners are cut by ears (ear_cutter.hpp). With more of them a sweep over the corners (contour_sweep.hpp)
/// finds where contours touch and cross, and cuts triangles as it goes (monotone_chains.hpp); edges are then flipped, so
/// that few triangles are slender (flip_edges.hpp). O(n log n) for n corners, but for the flips, whose number has a linear
/// bound. Contours that cross, or that wind round a point more than once, are left to the ears, whatever the number of
/// corners: O(n^2) as a rule.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Point2> points,
                                                      std::span<const std::uint32_t> contour_end, bool* whole = nullptr);

/// The answer of triangulate() for `whole`, in less time.
bool triangles_are_whole(std::span<const Point2> points, std::span<const std::uint32_t> contour_end);

}  // namespace ligne
