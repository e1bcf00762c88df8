#pragma once
/// The integer lattice on which areas hide and clip lines, and exact decisions on it. Private to plotting.
///
/// Points are rounded to whole steps of 2^-14 mm, |x|, |y| < 2^35 (a kilometre has 2^34 steps). Differences have 36
/// bits and determinants 73, which 128-bit integers hold. Of three points that are collinear before rounding, each
/// moves by up to half a step along each axis, which changes the determinant by at most |dx| + |dy| of the segment. Up
/// to that value a vertex counts as lying on the segment.

#include <cmath>
#include <compare>
#include <cstdint>

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

}  // namespace ligne::svg
