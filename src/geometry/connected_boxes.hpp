#pragma once
/// Groups of rectangles that overlap.

#include <span>

#include "base/disjoint_sets.hpp"

namespace ligne {

/// A rectangle [x0, x1] x [y0, y1] with sides along the axes.
struct AxisBox {
  double x0, y0, x1, y1;
};

/// Sets of boxes that are connected by common inner points. Boxes that share only a border are not connected, and a box
/// without inner points is connected to none.
///
/// A sweep from left to right keeps the open boxes as intervals of y in a segment tree. Each node knows which of the
/// boxes stored at it and below it ends last, and whether all open ones are known to be in one set. A new box is joined
/// with the last box of every node on its path. Below the nodes that store it, the descent stops at nodes whose boxes
/// are known to be in one set; afterwards all nodes passed are such nodes. So many boxes at one place cost no more than
/// others: O(n log n) joins.
DisjointSets connect_boxes(std::span<const AxisBox> boxes);

}  // namespace ligne
