#pragma once
/// Exact points on lattice segments. The point that two segments share lies on no lattice, but its parameter on either
/// segment is a quotient of two exact determinants.
///
/// Notation: the point of segment s at the parameter t is s.a + t (s.b - s.a). A parameter is num / den with whole
/// numbers, den > 0, the size of num and den at most 2^53, so both are exact doubles. Products of two of them have 106
/// bits. Each sign below is first computed in doubles; if they leave it open, 128-bit whole numbers decide.

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

/// Relative error bound of a difference of two rounded products: a larger difference has the right sign. Each product
/// carries one rounding of 2^-53, and another one if a factor is itself a difference; the subtraction carries a third.
inline constexpr double kProductRounding = 0x1p-50;

/// Sign of a b - c d for whole numbers below 2^54, in whole numbers of 128 bits.
int exact_product_difference_sign(double a, double b, double c, double d);

/// Sign of a b - c d, exact. Doubles decide in most cases.
inline int product_difference_sign(double a, double b, double c, double d) {
  const double p = a * b, q = c * d, difference = p - q;
  const double doubt = kProductRounding * (std::abs(p) + std::abs(q));
  if (difference > doubt) return 1;
  if (difference < -doubt) return -1;
  return exact_product_difference_sign(a, b, c, d);
}

/// -1, 0, +1 if s is less than, equal to, greater than t.
inline int compare(SegmentParameter s, SegmentParameter t) { return product_difference_sign(s.num, t.den, t.num, s.den); }

/// Side of the line on which the point of s at t lies: the sign of orientation(line.a, line.b, point).
int side(const LatticeSegment& line, const LatticeSegment& s, SegmentParameter t);

/// Twice the area spanned by the directions of the two segments; 0 if they are parallel. Exact.
inline double cross(const LatticeSegment& s, const LatticeSegment& t) { return s.dx() * t.dy() - s.dy() * t.dx(); }

/// Parameter on `on` at which the line of `with` meets the line of `on`. Requires cross(on, with) != 0.
inline SegmentParameter crossing(const LatticeSegment& on, const LatticeSegment& with) {
  const double num = orientation(with.a, with.b, on.a);
  const double den = cross(on, with);
  return den > 0 ? SegmentParameter{num, den} : SegmentParameter{-num, -den};
}

/// A point of the fine lattice, whose step is 2^-kFineBits of a lattice step.
struct FinePoint {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const FinePoint&, const FinePoint&) = default;
};
inline constexpr int kFineBits = 16;

inline FinePoint fine(LatticePoint p) {
  return {std::int64_t{p.x} * (1 << kFineBits), std::int64_t{p.y} * (1 << kFineBits)};
}

/// The nearest point of the fine lattice (halves up). It depends on the true point alone: all segments through a point
/// give it the same coordinates to the last bit.
FinePoint fine_point(const LatticeSegment& s, SegmentParameter t);

inline Point2 to_mm(const Lattice& lattice, FinePoint p) {
  constexpr double kPart = 1.0 / (1 << kFineBits);
  return {lattice.origin_mm.x + static_cast<double>(p.x) * kPart * lattice.step_mm,
          lattice.origin_mm.y + static_cast<double>(p.y) * kPart * lattice.step_mm};
}

}  // namespace ligne
