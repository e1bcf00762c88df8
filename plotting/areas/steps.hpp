#pragma once
/// The integer lattice on which areas hide and clip lines, and exact decisions on it. Private to plotting.
///
/// Points are rounded to whole steps of 2^-14 mm, |x|, |y| < 2^35 (a kilometre has 2^34 steps). Differences have 36
/// bits and determinants 73, which 128-bit integers hold. Of three points that are collinear before rounding, each
/// moves by up to half a step along each axis, which changes the determinant by at most |dx| + |dy| of the segment. Up
/// to that value a vertex counts as lying on the segment.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/exact_segment.hpp"
#include "geometry/point.hpp"

namespace ligne::svg {

inline constexpr double kStepsPerMm = 0x1p14;

/// A point of the lattice, in steps.
struct StepPoint {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const StepPoint&, const StepPoint&) = default;
};

/// The nearest lattice point.
inline StepPoint to_steps(Point2 mm) {
  const auto nearest = [](double v) { return static_cast<std::int64_t>(v + std::copysign(0.5, v)); };
  return {nearest(mm.x * kStepsPerMm), nearest(mm.y * kStepsPerMm)};
}

/// A segment between two different lattice points.
struct StepSegment {
  StepPoint a, b;

  std::int64_t dx() const { return b.x - a.x; }
  std::int64_t dy() const { return b.y - a.y; }
  /// Largest determinant of a vertex that lies on the segment, up to rounding.
  std::int64_t tolerance() const { return std::abs(dx()) + std::abs(dy()); }
  friend auto operator<=>(const StepSegment&, const StepSegment&) = default;
};

/// Twice the signed area of a, b, p; exact. Positive if p lies on the plus side of a -> b: the side of +y for a segment
/// towards +x.
inline Int128 orientation(const StepSegment& s, StepPoint p) {
  return Int128{s.dx()} * (p.y - s.a.y) - Int128{s.dy()} * (p.x - s.a.x);
}

/// Side of the segment's supporting line for a point with this orientation; 0 if the point lies on it up to rounding.
inline int side_of(const StepSegment& s, Int128 orientation) {
  const Int128 on = s.tolerance();
  return (orientation > on) - (orientation < -on);
}

/// Whether the point lies on the segment up to rounding.
bool lies_on(const StepSegment& s, StepPoint p);

/// A place along a segment, as the fraction num / den of it, den > 0. Exact; `value` is the quotient in doubles.
struct Along {
  Int128 num = 0, den = 1;
  double value = 0;
};
inline constexpr Along kBegin{0, 1, 0}, kEnd{1, 1, 1};

Along along(Int128 num, Int128 den);
/// The place on the segment that is nearest to the point.
Along nearest_to(const StepSegment& s, StepPoint p);
/// The place where the supporting lines of segment and edge cross. `a` and `b` are the orientations of the edge's ends,
/// and differ.
Along crossing(const StepSegment& s, const StepSegment& edge, Int128 a, Int128 b);

inline bool is_before_end(const Along& t) { return t.num < t.den; }
inline bool is_behind_begin(const Along& t) { return t.num > 0; }

/// -1, 0 or +1 as s comes before t, equals it, or comes after it. Both lie strictly within the segment.
int compare(const Along& s, const Along& t);

/// A box in steps, as doubles: they are exact below 2^53.
struct StepBox {
  double low_x = 1e300, low_y = 1e300, high_x = -1e300, high_y = -1e300;

  void extend(StepPoint p);
  void extend(const StepBox& other);
  bool empty() const { return low_x > high_x; }
  bool meets(const StepBox& o) const {
    return low_x <= o.high_x && high_x >= o.low_x && low_y <= o.high_y && high_y >= o.low_y;
  }
  /// The box, grown by this many steps on each side.
  StepBox grown(double steps) const { return {low_x - steps, low_y - steps, high_x + steps, high_y + steps}; }
};

StepBox box_of(const StepSegment& s);

/// Largest distance, in lattice steps, by which a vertex that lies on a segment up to rounding may lie outside its box.
inline constexpr double kRoundingSteps = 2;

/// A balanced tree of bounding boxes over edges in the order of their contours: consecutive edges lie near each other.
class EdgeTree {
 public:
  EdgeTree() = default;
  explicit EdgeTree(std::span<const StepSegment> edges);

  const StepBox& box() const { return box_; }

  /// Calls visit(i) for all edges in order, except edges in boxes for which `may_intersect` is false. Returns the
  /// number of boxes and edges tested.
  template <class MayMeet, class Visit>
  std::size_t search(MayMeet may_intersect, Visit visit) const {
    std::size_t looked_at = 0;
    if (count_ > 0) search_node(levels_.size() - 1, 0, may_intersect, visit, looked_at);
    return looked_at;
  }

 private:
  /// Edges per leaf, and children per node. Adjustable.
  static constexpr std::size_t kLeaf = 4, kChildren = 4;

  template <class MayMeet, class Visit>
  void search_node(std::size_t level, std::size_t node, MayMeet& may_intersect, Visit& visit, std::size_t& looked_at) const {
    ++looked_at;
    if (!may_intersect(levels_[level][node])) return;
    const std::size_t below = level == 0 ? count_ : levels_[level - 1].size(), many = level == 0 ? kLeaf : kChildren;
    const std::size_t end = node * many + many < below ? node * many + many : below;
    for (std::size_t i = node * many; i < end; ++i) {
      if (level > 0) {
        search_node(level - 1, i, may_intersect, visit, looked_at);
      } else {
        ++looked_at;
        visit(i);
      }
    }
  }

  std::size_t count_ = 0;
  StepBox box_;
  std::vector<std::vector<StepBox>> levels_;  ///< from the leaves to the root
};

}  // namespace ligne::svg
