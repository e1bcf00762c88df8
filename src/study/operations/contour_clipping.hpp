#pragma once
/// A contour clipped by a convex one, [Boulle1980] 3.2.3.2 and 3.2.3.3: side by side (Sutherland and Hodgman), and convex
/// against convex in one pass (Shamos). The clip of any contour by any other is the program's own,
/// geometry/clip_contour_by_contour.hpp.
///
/// Contours turn positively (orientation() > 0). Corners that are made are rounded to doubles.

#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::studies {

using Contour = std::vector<Point2>;

struct ContourClipCounts {
  std::uint64_t signs = 0;      ///< points against lines, or sides compared at one abscissa
  std::uint64_t crossings = 0;  ///< computed
};

/// Sutherland and Hodgman: the subject, convex or not, cut by the half plane of each side of the clip contour after the
/// other. What falls apart stays one contour, whose parts are joined along the sides of the clip contour (figure 3.18).
Contour clip_side_by_side(const Contour& subject, const Contour& clip, ContourClipCounts& counts);

/// Shamos, in the form by slabs: between neighbouring abscissas of corners both contours are trapezoids, so each slab takes
/// constant time and the whole the sum of the corners. Both convex. Empty when they have no area in common.
Contour clip_convex(const Contour& a, const Contour& b, ContourClipCounts& counts);

/// Twice the area.
double twice_area_of(const Contour& contour);

}  // namespace ligne::studies
