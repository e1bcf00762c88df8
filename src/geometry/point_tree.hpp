#pragma once
/// Search for near points in a set that may shrink.

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// A k-d tree over points, which keep their indices. Points can be removed. The search never enters a subtree without
/// points, so a query takes logarithmic time even if few points are left. Which of several equally near points is found
/// depends on the points alone.
class PointTree {
 public:
  struct Neighbour {
    double squared;  ///< square of the distance
    std::uint32_t point;
  };

  explicit PointTree(std::span<const Point2> points);

  /// Removes a point, which must not have been removed before.
  void remove(std::uint32_t point);

  /// The nearest of the remaining points; kNone if there is none.
  std::uint32_t nearest(Point2 p) const;

  /// Finds the `count` remaining points nearest to p, sorted by distance and index.
  void nearest(Point2 p, std::size_t count, std::vector<Neighbour>& found) const;

  /// Calls visit(squared distance, point) for the remaining points in each leaf for whose box, and all boxes around it,
  /// enter(squared distance of the box, box) returns true. Of two boxes the nearer one comes first.
  template <class Enter, class Visit>
  void search(Point2 p, const Enter& enter, const Visit& visit) const {
    search_node(0, squared_distance(nodes_[0].box, p), p, enter, visit);
  }

 private:
  struct Node {
    Rect box;
    std::uint32_t first, last;          ///< its points in order_
    std::uint32_t left = 0, right = 0;  ///< children; 0: a leaf
    std::uint32_t parent = 0;
    std::uint32_t left_over = 0;  ///< points not yet removed
  };

  static double squared_distance(const Rect& box, Point2 p) {
    const double x = std::max({box.min.x - p.x, 0.0, p.x - box.max.x});
    const double y = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
    return x * x + y * y;
  }
  std::uint32_t build(std::uint32_t first, std::uint32_t last, std::uint32_t parent);

  template <class Enter, class Visit>
  void search_node(std::uint32_t index, double squared, Point2 p, const Enter& enter, const Visit& visit) const {
    const Node& node = nodes_[index];
    if (node.left_over == 0 || !enter(squared, node.box)) return;
    if (node.left == 0) {
      for (std::uint32_t i = node.first; i < node.last; ++i) {
        const Point2 d = points_[i] - p;
        if (is_left_[i]) visit(d.x * d.x + d.y * d.y, order_[i]);
      }
      return;
    }
    std::uint32_t near = node.left, far = node.right;
    double to_near = squared_distance(nodes_[near].box, p), to_far = squared_distance(nodes_[far].box, p);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    search_node(near, to_near, p, enter, visit);
    search_node(far, to_far, p, enter, visit);
  }

  std::vector<Point2> points_;           ///< in the order of the leaves, once the tree is built
  std::vector<std::uint32_t> order_;     ///< the numbers of the points in that order
  std::vector<std::uint32_t> place_of_;  ///< per point: its place in order_
  std::vector<std::uint32_t> leaf_of_;   ///< per point: its leaf
  std::vector<char> is_left_;            ///< in the order of the leaves: 1 until the point is removed
  std::vector<Node> nodes_;
};

}  // namespace ligne
