#pragma once
/// Points on lattice segments, exactly: what two segments have in common lies on no lattice, but its parameter on either of
/// them is a quotient of two exact determinants.
///
/// Notation: the point of segment s at the parameter t is s.a + t (s.b - s.a). A parameter is num / den with whole numbers,
/// den > 0, |num| and den at most 2^53, so both are exact doubles. Products of two of them have 106 bits: each sign below is
/// first looked for in double arithmetic, and where that leaves it open in whole numbers of 128 bits.

#include <cmath>
#include <compare>
#include <cstdint>

#include "geometry/lattice.hpp"

namespace ligne {

__extension__ using Int128 = __int128;

/// A segment, or the whole line through its two ends, which are different.
struct LatticeSegment {
  LatticePoint a, b;

  double dx() const { return double(b.x) - a.x; }
  double dy() const { return double(b.y) - a.y; }
  friend bool operator==(const LatticeSegment&, const LatticeSegment&) = default;
};

struct SegmentParameter {
  double num = 0, den = 1;
};
inline constexpr SegmentParameter kSegmentBegin{0, 1}, kSegmentEnd{1, 1};

inline double value(SegmentParameter t) { return t.num / t.den; }

/// Two rounded products that differ by more than this part of their sizes differ in truth: each carries one rounding of
/// 2^-53 and, where a factor is itself a difference, another one; the difference carries a third.
inline constexpr double kProductRounding = 0x1p-50;

/// Sign of a b - c d for whole numbers below 2^54, in whole numbers of 128 bits.
int exact_product_difference_sign(double a, double b, double c, double d);

/// Sign of a b - c d, exact; mostly doubles decide.
inline int product_difference_sign(double a, double b, double c, double d) {
  const double p = a * b, q = c * d, difference = p - q;
  const double doubt = kProductRounding * (std::abs(p) + std::abs(q));
  if (difference > doubt) return 1;
  if (difference < -doubt) return -1;
  return exact_product_difference_sign(a, b, c, d);
}

/// -1, 0, +1 as s is less than, equal to, greater than t.
inline int compare(SegmentParameter s, SegmentParameter t) { return product_difference_sign(s.num, t.den, t.num, s.den); }

/// Side of the line on which the point of s at t lies: the sign of orientation(line.a, line.b, point).
int side(const LatticeSegment& line, const LatticeSegment& s, SegmentParameter t);

/// Twice the area that the directions of the two span; 0 when they are parallel. Exact.
inline double cross(const LatticeSegment& s, const LatticeSegment& t) { return s.dx() * t.dy() - s.dy() * t.dx(); }

/// Where the line of `with` meets the line of `on`, as a parameter on the latter. Requires cross(on, with) != 0.
inline SegmentParameter crossing(const LatticeSegment& on, const LatticeSegment& with) {
  const double num = orientation(with.a, with.b, on.a);
  const double den = cross(on, with);
  return den > 0 ? SegmentParameter{num, den} : SegmentParameter{-num, -den};
}

/// A point of the fine lattice: 2^kFineBits parts of a step.
struct FinePoint {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const FinePoint&, const FinePoint&) = default;
};
inline constexpr int kFineBits = 16;

inline FinePoint fine(LatticePoint p) {
  return {std::int64_t{p.x} * (1 << kFineBits), std::int64_t{p.y} * (1 << kFineBits)};
}

/// The nearest point of the fine lattice (halves up). It depends on the true point alone: however a point is come by, from
/// whatever segments through it, it gets the same coordinates to the last bit.
FinePoint fine_point(const LatticeSegment& s, SegmentParameter t);

inline Point2 to_mm(const Lattice& lattice, FinePoint p) {
  constexpr double kPart = 1.0 / (1 << kFineBits);
  return {lattice.origin_mm.x + static_cast<double>(p.x) * kPart * lattice.step_mm,
          lattice.origin_mm.y + static_cast<double>(p.y) * kPart * lattice.step_mm};
}

}  // namespace ligne
