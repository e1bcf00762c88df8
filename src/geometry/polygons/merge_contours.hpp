#pragma once
/// Areas that share borders, made one area.

#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Closed contours, first point not repeated, that enclose the same points by the even-odd rule as `contours` do, without
/// the edges that an even number of contours pass. A contour that shares no edge comes back as it is. O(n log n).
std::vector<std::vector<Point2>> merge_contours(const std::vector<std::vector<Point2>>& contours);

}  // namespace ligne
