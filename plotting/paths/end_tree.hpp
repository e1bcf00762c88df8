#pragma once
/// Search for nearest points in a set that shrinks.

#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/point.hpp"

namespace ligne {

/// A k-d tree over points, which keep their indices. Points can be removed. The search never enters a subtree without
/// points, so a query takes logarithmic time even if few points are left. Which of several equally near points is found
/// depends on the points alone.
class EndTree {
 public:
  struct Neighbour {
    double squared;  ///< distance, mm^2
    std::uint32_t point;
  };

  explicit EndTree(std::span<const Point2> points);

  /// Removes a point, which must not have been removed before.
  void remove(std::uint32_t point);

  /// The nearest of the remaining points; kNone if there is none.
  std::uint32_t nearest(Point2 p) const;

  /// Finds the `count` remaining points nearest to p, sorted by distance and index.
  void nearest(Point2 p, std::size_t count, std::vector<Neighbour>& found) const;

 private:
  struct Node {
    Rect box;
    std::uint32_t first, last;          ///< its points in order_
    std::uint32_t left = 0, right = 0;  ///< children; 0: a leaf
    std::uint32_t parent = 0;
    std::uint32_t left_over = 0;  ///< points not yet removed
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last, std::uint32_t parent);
  template <class Take>
  void search(std::uint32_t node, Point2 p, const double& limit, const Take& take) const;

  std::vector<Point2> points_;           ///< in the order of the leaves, once the tree is built
  std::vector<std::uint32_t> order_;     ///< the numbers of the points in that order
  std::vector<std::uint32_t> place_of_;  ///< per point: its place in order_
  std::vector<std::uint32_t> leaf_of_;   ///< per point: its leaf
  std::vector<char> there_;              ///< in the order of the leaves: 1 until the point is removed
  std::vector<Node> nodes_;
};

}  // namespace ligne
