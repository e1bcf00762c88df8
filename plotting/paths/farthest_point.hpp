#pragma once
/// Repeated queries for the point of a part of a line that is farthest from a segment.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// A tree over the points in their order. Each node holds the convex hull of a block of points, on which the farthest
/// point in a direction is found by bisection (as in Hershberger and Snoeyink 1992, who keep the hulls of the paths to
/// be split). The point farthest from a segment lies on the hull, since the distance from a convex set is a convex
/// function.
///
/// A block between the perpendiculars through the segment's ends needs only its farthest points along the normal. The
/// search descends into another block only while it may hold a farther point.
///
/// Building takes O(n log n) for n points. A query takes O(log^2 n) while few blocks reach beyond the ends of the
/// segment, and O(n) at worst.
class FarthestPoint {
 public:
  explicit FarthestPoint(std::span<const Point2> points);

  struct Found {
    std::uint32_t at;
    double squared_distance;
  };

  /// The point between the two indices that is farthest from their segment; `from` and -1 if there is none. Of equally
  /// far points the first is found, except among points on one side of a hull. Another point may be farther by
  /// kSameDistance, relative to the squared distance.
  Found between(std::uint32_t from, std::uint32_t to) const;

 private:
  /// The lower and the upper chain of a hull, each from its leftmost to its rightmost point. At equal x the point with
  /// the lower y is the left one.
  struct Node {
    std::uint32_t lower_begin, upper_begin, end;  ///< in corners_
    Rect box;
  };
  struct Question;

  void add_hull(std::span<const std::uint32_t> sorted);
  void look_at(Question& question, std::size_t level, std::uint32_t block) const;
  bool may_hold_more(Question& question, const Node& node) const;
  std::array<std::uint32_t, 3> extreme(const Node& node, Point2 direction) const;

  std::span<const Point2> points_;
  std::vector<std::vector<Node>> levels_;  ///< hulls of blocks of kLeaf * 2^level points; level 0 has none
  std::vector<std::uint32_t> corners_;
};

}  // namespace ligne
