#pragma once
/// A contour clipped by a convex one, [Boulle1980] 3.2.3.2 and 3.2.3.3: side by side (Sutherland and Hodgman), and convex
/// against convex in one pass (Shamos). The clip of any contour by any other is the program's own,
/// geometry/polygons/clip_contour_by_contour.hpp.
///
/// Contours turn positively (orientation() > 0). Corners that are made are rounded to doubles.

#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::studies {

using Contour = std::vector<Point2>;

struct ContourClipCounts {
  std::uint64_t signs = 0;      ///< points against lines, and rays against rays
  std::uint64_t crossings = 0;  ///< computed
};

/// Sutherland and Hodgman: the subject, convex or not, cut by the half plane of each side of the clip contour after the
/// other. What falls apart stays one contour, whose parts are joined along the sides of the clip contour (figure 3.18).
Contour clip_side_by_side(const Contour& subject, const Contour& clip, ContourClipCounts& counts);

/// Shamos, both convex: rays from an inner point of b through its corners part the plane into sectors, one for each side of
/// b. The first corner of a is looked up among them; from there both contours are walked round together, each side against
/// what lies in its sectors, so all takes the sum of the sides. Where a does not contain the point its sides are two chains,
/// the far and the near one (figure 3.21). Exact but for the crossings computed, when coordinates are whole and below 2^22:
/// all rays are multiples. Empty when they have no area in common, or a line or point.
Contour clip_convex(const Contour& a, const Contour& b, ContourClipCounts& counts);

/// Twice the area.
double twice_area_of(const Contour& contour);

}  // namespace ligne::studies
