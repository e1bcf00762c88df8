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
/// the other way round, or a hole outside, was not cut. Method: holes are joined to the outer contour by bridges, then ears
/// are cut (Meisters 1975; bridges after Eberly 2002).
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Point2> points,
                                                      std::span<const std::uint32_t> contour_end, bool* whole = nullptr);

}  // namespace ligne
