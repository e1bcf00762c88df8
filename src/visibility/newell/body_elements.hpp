#pragma once
/// Convex bodies as elements of the list: one silhouette in place of many faces.
///
/// [Boulle1980] 1.2.2.3 c consolidates a convex object into its silhouette, and 2.5.2.7 puts its faces back into the list,
/// the back faces before the front faces. A body that has no place among the others as a whole is opened: its faces take its
/// place.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "visibility/newell/element.hpp"

namespace ligne::newell {

struct BodyElement {
  std::vector<Element> members;  ///< an element for each face, the back faces first
  std::size_t back_count = 0;
  std::vector<Point2> silhouette;  ///< convex hull on the page, mm, positively turned
};

/// The convex hull of points, positively turned, without straight corners. O(n log n) (Andrew, Another efficient algorithm
/// for convex hulls in two dimensions, 1979).
std::vector<Point2> convex_hull(std::vector<Point2> points);

}  // namespace ligne::newell
