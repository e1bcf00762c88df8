#pragma once
/// A tree over points of the page that finds whether one lies in a rectangle.

#include <cstddef>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// A k-d tree [Bentley1975]. Building takes O(n log n); a query takes O(sqrt n) at most, also if points coincide.
class MarkTree {
 public:
  explicit MarkTree(std::vector<Point2> points);

  /// Whether a point is nearer to `center` than `half` along both axes.
  bool any_within(Point2 center, Point2 half) const { return !nodes_.empty() && any_within(0, center, half); }

 private:
  /// Points [begin, end) and their bounds. The children are `left` and left + 1; `left` is 0 in a leaf.
  struct Node {
    std::size_t begin = 0, end = 0, left = 0;
    Rect bounds;
  };

  void build();
  bool any_within(std::size_t node, Point2 center, Point2 half) const;

  std::vector<Point2> points_;
  std::vector<Node> nodes_;
};

}  // namespace ligne
