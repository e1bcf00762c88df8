#pragma once
/// Clipping of a contour by a convex one, [Boulle1980] 3.2.3.2 and 3.2.3.3: side by side (Sutherland and Hodgman), and
/// convex by convex in one pass (Shamos). The clip of any contour by any other is the program's own,
/// geometry/polygons/clip_contour_by_contour.hpp.
///
/// Contours turn positively (orientation() > 0). Computed corners are rounded to doubles.

#include <cstdint>
#include <vector>

#include "geometry/point.hpp"

namespace ligne::studies {

using Contour = std::vector<Point2>;

struct ContourClipCounts {
  std::uint64_t signs = 0;      ///< tests of points against lines and of rays against rays
  std::uint64_t crossings = 0;  ///< computed crossings
};

/// Sutherland and Hodgman: cuts the subject, convex or not, by the half plane of each side of the clip contour in turn.
/// Separate parts stay one contour, joined along the sides of the clip contour (figure 3.18).
Contour clip_side_by_side(const Contour& subject, const Contour& clip, ContourClipCounts& counts);

/// Shamos, both contours convex: rays from an inner point of b through its corners divide the plane into sectors, one per
/// side of b. A search finds the sector of the first corner of a. From there both contours are walked round together, each
/// side tested only within its sectors, so the time is linear in the number of sides. If a does not contain the point, its
/// sides form a far and a near chain (figure 3.21). All tests are exact for integer coordinates below 2^22, because the rays
/// are scaled; only the crossings are rounded. Empty if the intersection has no area.
Contour clip_convex(const Contour& a, const Contour& b, ContourClipCounts& counts);

/// Twice the area of the contour.
double twice_area_of(const Contour& contour);

}  // namespace ligne::studies
