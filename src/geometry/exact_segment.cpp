#include "geometry/exact_segment.hpp"

namespace ligne {
namespace {

Int128 whole(double v) { return static_cast<std::int64_t>(v); }

/// floor(d num / den + 1/2) on the fine lattice. |d| <= 2^26, so that the largest number below has 26 + 53 + 17 bits.
std::int64_t fine_offset(double d, SegmentParameter t) {
  constexpr double kParts = 1 << kFineBits;
  // Bound on three roundings of a value below 2^27 + 16 bits. Doubles decide if the nearest half is farther than this.
  constexpr double kDoubt = 0x1p-7;
  const double v = d * (t.num / t.den) * kParts + 0.5;
  const double below = std::floor(v);
  if (v - below > kDoubt && v - below < 1 - kDoubt && std::abs(v) < 0x1p44) return static_cast<std::int64_t>(below);
  const Int128 num = 2 * whole(d) * whole(t.num) * (1 << kFineBits) + whole(t.den), den = 2 * whole(t.den);
  Int128 q = num / den;
  if (num % den < 0) --q;
  return static_cast<std::int64_t>(q);
}

}  // namespace

int exact_product_difference_sign(double a, double b, double c, double d) {
  const Int128 exact = whole(a) * whole(b) - whole(c) * whole(d);
  return (exact > 0) - (exact < 0);
}

int side(const LatticeSegment& line, const LatticeSegment& s, SegmentParameter t) {
  const double at_a = orientation(line.a, line.b, s.a), at_b = orientation(line.a, line.b, s.b);
  // at_a (den - num) + at_b num; den - num may need 54 bits and is formed anew in whole numbers.
  const double p = at_a * (t.den - t.num), q = at_b * t.num, sum = p + q;
  const double doubt = kProductRounding * (std::abs(p) + std::abs(q));
  if (sum > doubt) return 1;
  if (sum < -doubt) return -1;
  const Int128 exact = whole(at_a) * (whole(t.den) - whole(t.num)) + whole(at_b) * whole(t.num);
  return (exact > 0) - (exact < 0);
}

FinePoint fine_point(const LatticeSegment& s, SegmentParameter t) {
  const FinePoint a = fine(s.a);
  return {a.x + fine_offset(s.dx(), t), a.y + fine_offset(s.dy(), t)};
}

}  // namespace ligne
