#pragma once
/// Convex bodies as list elements: one silhouette replaces many faces.
///
/// [Boulle1980] 1.2.2.3 c consolidates a convex object into its silhouette, and 2.5.2.7 puts its faces back into the list,
/// back faces before front faces. A body that can not be ordered as a whole is opened: its faces replace it.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "visibility/newell/element.hpp"

namespace ligne::newell {

struct BodyElement {
  std::vector<Element> members;  ///< one element per face, back faces first
  std::size_t back_count = 0;
  std::vector<Point2> silhouette;  ///< convex hull on the page, mm, in positive orientation
};

/// Convex hull in positive orientation, without collinear corners. O(n log n) (Andrew, Another efficient algorithm for
/// convex hulls in two dimensions, 1979).
std::vector<Point2> convex_hull(std::vector<Point2> points);

}  // namespace ligne::newell
