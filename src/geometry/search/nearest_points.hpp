#pragma once
/// Searches in a set of points of the page that shrinks.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"
#include "geometry/search/point_tree.hpp"

namespace ligne {

/// A set of points, which keep their indices. Points can be removed. The search never enters a subtree without points, so a
/// query takes logarithmic time even if few points are left. Which of several equally near points is found depends on the
/// points alone.
class NearestPoints {
 public:
  struct Neighbour {
    double squared;  ///< square of the distance
    std::uint32_t point;
  };

  explicit NearestPoints(std::span<const Point2> points);

  /// Removes a point, which must not have been removed before.
  void remove(std::uint32_t point);

  /// Finds the `count` remaining points nearest to p, sorted by distance and index; fewer where fewer remain.
  void nearest(Point2 p, std::size_t count, std::vector<Neighbour>& found) const;

  /// Whether a point, removed or not, is nearer to `center` than `half` along both axes. O(sqrt n).
  bool any_within(Point2 center, Point2 half) const;

 private:
  PointTree<2, double> tree_;
  std::vector<Point2> points_;           ///< in the order of the tree, so that a search reads neighbouring memory
  std::vector<std::uint32_t> place_of_;  ///< per point: its place in that order
  std::vector<char> is_left_;            ///< in that order: 1 until the point is removed
  std::vector<std::uint32_t> left_in_;   ///< by node of the tree: number of points not yet removed
};

}  // namespace ligne
