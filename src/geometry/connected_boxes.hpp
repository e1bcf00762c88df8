#pragma once
/// Which rectangles hang together by overlapping.

#include <span>

#include "base/disjoint_sets.hpp"

namespace ligne {

/// A rectangle [x0, x1] x [y0, y1] with sides along the axes.
struct AxisBox {
  double x0, y0, x1, y1;
};

/// Sets of boxes that are connected by common inner points: two boxes with only a border in common are not, nor is one
/// without an inner point with any.
///
/// A sweep from left to right. The open boxes are intervals of y in a segment tree. A node knows, of the boxes that are
/// stored at it and below it, the one that ends last, and whether all that were open are known to be one set. A new box is
/// joined with the last of every node on its way and, below its own nodes, with the last of those whose boxes are known to
/// be one set; afterwards all below are. So crowds cost no more than others: O(n log n) joins.
DisjointSets connect_boxes(std::span<const AxisBox> boxes);

}  // namespace ligne
