#pragma once
/// The point of a stretch of a line that is farthest from a segment, asked again and again.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// A tree over the points in their order: each node holds the convex hull of a block of them, on which the farthest point in
/// a direction is found by bisection (the hulls of Hershberger and Snoeyink 1992, who keep those of the paths to be cut).
/// The point farthest from a segment is one on the hull, since the distance from a convex set is a convex function.
///
/// A block that lies between the perpendiculars through the segment's ends is done with the points farthest along its
/// normal. Of others the tree is descended into where they can still hold a farther point.
///
/// O(n log n) to build for n points. A question takes O(log^2 n) while few blocks reach beyond the ends of the segment, and
/// O(n) at worst.
class FarthestPoint {
 public:
  explicit FarthestPoint(std::span<const Point2> points);

  struct Found {
    std::uint32_t at;
    double squared_distance;
  };

  /// The point between the two that is farthest from their segment; `from` and -1 when there is none. The first of equally
  /// far ones, but for those on one side of a hull. Another one may be farther by kSameDistance of its squared distance.
  Found between(std::uint32_t from, std::uint32_t to) const;

 private:
  /// Corners of a hull from its leftmost to its rightmost point, by either way; of equal x the lower y is the left one.
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
  std::vector<std::vector<Node>> levels_;  ///< of blocks of kLeaf * 2^level points; none of level 0
  std::vector<std::uint32_t> corners_;
};

}  // namespace ligne
