#pragma once
/// Finds the ends of segments that lie along a line.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/search/point_tree.hpp"
#include "geometry/segment_overlap.hpp"

namespace ligne {

/// An end of a segment.
struct PlacedEnd {
  LatticePoint p, far;  ///< the end, and the other end of its segment
  std::uint32_t segment;
};

/// A segment of the page with its length and direction (line_directions::direction()).
struct DirectedSegment {
  LatticePoint from, to;
  double length, direction;

  DirectedSegment(LatticePoint a, LatticePoint b)
      : from(a), to(b), length(ligne::length(a, b)), direction(line_directions::direction(a, b)) {}
};

/// The ends of segments in a range of directions, in a tree of boxes. The coordinates of the tree are u and v of the frame
/// of the range, the direction of the segment, and the logarithm of its length. u and v separate segments side by side.
/// Directions separate segments that meet in one point: far from the ends of a line, a long segment overlaps it only if
/// their directions agree within the tolerance over the common interval.
class SegmentEndTree {
 public:
  SegmentEndTree() = default;
  /// `middle` is the middle of the range of directions, `tolerance` the distance within which a point counts as on a line.
  SegmentEndTree(const std::vector<PlacedEnd>& ends, double middle, double tolerance);

  /// All ends, leaf by leaf, so that neighbours in the list are mostly neighbours on the page.
  const std::vector<PlacedEnd>& ends() const { return ends_; }

  /// Calls visit(end) for segments that are not longer than the given one, may overlap it, and have an end inside it; and
  /// for segments between the same two points. Of two segments that overlap, the longer one has an end of the other on it
  /// (segment_overlap.hpp). If both ends of a segment lie inside, visits one of them.
  template <class Visit>
  void for_each_along(const DirectedSegment& segment, const Visit& visit) const;

 private:
  using Box = PointTree<4>::Box;

  /// A segment in the frame of the tree.
  struct Line {
    double u0, v0, u1, v1;                    ///< u0 <= u1
    double slope = 0, v_low = 0, v_high = 0;  ///< v_low + slope u and v_high + slope u bound all points within the reach
    std::int32_t direction = 0;
    std::array<std::int32_t, 2> low{}, high{};  ///< box around all points within the reach of the segment
    std::array<std::int32_t, 2> ends[2]{};
  };

  /// Weights of the sides by which the tree is divided. Segments run along u with a mean slope of a tenth, so fewer of them
  /// meet a box that is long along u. Directions divide only places where many segments meet. Adjustable.
  static constexpr PointTree<4>::Weights kWeights{1, 6, 0.1, 1};
  static constexpr double kRounding = 2;  ///< lattice steps; more than the rounding error of any position here
  /// Least common interval over which directions are compared, in tolerances; over shorter ones they differ too much.
  /// Adjustable.
  static constexpr double kCompared = 128;

  static std::int32_t rounded(double v) {
    return static_cast<std::int32_t>(static_cast<std::int64_t>(v + 0x1p31 + 0.5) - (std::int64_t{1} << 31));
  }
  std::int32_t rounded_direction(double direction) const {
    return rounded(line_directions::difference(direction, middle_) * steps_per_direction_);
  }
  /// Whether all ends are more than the reach away from the box of the segment.
  bool is_apart(const DirectedSegment& s) const {
    return std::max(s.from.x, s.to.x) < low_.x || std::min(s.from.x, s.to.x) > high_.x ||
           std::max(s.from.y, s.to.y) < low_.y || std::min(s.from.y, s.to.y) > high_.y;
  }
  Line line_of(const DirectedSegment& segment) const;
  bool may_hold(const Box& box, const Line& line) const;

  DirectionFrame frame_;
  double middle_ = 0, reach_ = 0;
  double steps_per_direction_ = 1;  ///< mean length of the segments: a turn moves their far ends by as many steps
  LatticePoint low_, high_;         ///< box around all points within the reach of the ends
  PointTree<4> tree_;
  std::vector<PlacedEnd> ends_;
};

/// Whether the box may hold ends along the line.
inline bool SegmentEndTree::may_hold(const Box& box, const Line& line) const {
  const double left = box.low[0], right = box.high[0];
  if (box.high[0] < line.low[0] || box.low[0] > line.high[0] || box.high[1] < line.low[1] || box.low[1] > line.high[1])
    return false;
  const bool rises = line.slope >= 0;
  if (box.high[1] < line.v_low + line.slope * (rises ? left : right)) return false;
  if (box.low[1] > line.v_high + line.slope * (rises ? right : left)) return false;
  if (box.low[0] == box.high[0] && box.low[1] == box.high[1]) {
    const std::array<std::int32_t, 2> p{box.low[0], box.low[1]};
    if (p == line.ends[0] || p == line.ends[1]) return box.low[2] <= line.direction && line.direction <= box.high[2];
  }
  const double inside = std::min(left - line.u0, line.u1 - right);
  if (inside < kCompared * reach_) return true;
  const double common = std::min(inside, static_cast<double>(std::uint32_t{1} << box.low[3]) / 2);
  if (common < kCompared * reach_) return true;
  // Over the common interval the distance changes by at most two tolerances, and a direction by at most two angles.
  const double most = 4 * reach_ / common * steps_per_direction_ + 2;
  return box.low[2] <= line.direction + most && box.high[2] >= line.direction - most;
}

template <class Visit>
void SegmentEndTree::for_each_along(const DirectedSegment& segment, const Visit& visit) const {
  if (ends_.empty() || is_apart(segment)) return;
  const Line line = line_of(segment);
  const LatticePoint from = segment.from, to = segment.to;
  const double dx = double(to.x) - from.x, dy = double(to.y) - from.y, most = reach_ * segment.length;
  const double squared = dx * dx + dy * dy;
  const auto is_near = [&](LatticePoint p) {
    return std::abs(dx * (double(p.y) - from.y) - dy * (double(p.x) - from.x)) <= most;
  };
  const auto is_between = [&](LatticePoint p) {
    const double along = dx * (double(p.x) - from.x) + dy * (double(p.y) - from.y);
    return along > 0 && along < squared;
  };
  const auto may_hold_some = [&](const Box& box) { return may_hold(box, line); };
  tree_.search(may_hold_some, [&](std::uint32_t e) {
    const auto& [p, far, number] = ends_[e];
    if (!is_near(p)) return;
    const double far_dx = double(far.x) - p.x, far_dy = double(far.y) - p.y;
    if (far_dx * far_dx + far_dy * far_dy > squared) return;
    if ((p == from && far != to) || (p == to && far != from)) return;
    if (p < far && is_between(far) && is_near(far)) return;
    visit(ends_[e]);
  });
}

/// The ends of segments: a tree for each range of directions, and one for the segments that are not long
/// (kLongInTolerances), whose directions mean little.
class SegmentEnds {
 public:
  /// `ends` holds both ends of each segment.
  SegmentEnds(std::vector<PlacedEnd> ends, double tolerance);

  std::size_t size() const { return size_; }

  /// Calls visit(ends of a tree) for each tree. Neighbours in a tree are near each other on the page and in memory.
  template <class Visit>
  void for_each_tree(const Visit& visit) const {
    for (const SegmentEndTree& tree : trees_) visit(tree.ends());
  }

  /// Calls visit(end) for the ends of short segments along the given one; if it is long, also for those of long segments
  /// of nearly its direction.
  template <class Visit>
  void for_each_along(const DirectedSegment& segment, const Visit& visit) const {
    trees_[kShort].for_each_along(segment, visit);
    if (segment.length <= longest_short_) return;
    const std::size_t low = range_of(segment.direction - kDirectionReach),
                      high = range_of(segment.direction + kDirectionReach);
    trees_[low].for_each_along(segment, visit);
    if (high != low) trees_[high].for_each_along(segment, visit);
  }

 private:
  /// Number of ranges of directions. A long segment searches one or two of them. Adjustable.
  static constexpr std::size_t kRanges = 20;
  static constexpr std::size_t kShort = kRanges;  ///< the group of the short segments

  static std::size_t range_of(double direction) {
    constexpr double kRange = line_directions::kCircle / kRanges;
    static_assert(2 * kDirectionReach < kRange);
    return static_cast<std::size_t>(std::floor(direction / kRange) + double{kRanges}) % kRanges;
  }

  double longest_short_;
  std::size_t size_;
  std::array<SegmentEndTree, kRanges + 1> trees_;
};

}  // namespace ligne
