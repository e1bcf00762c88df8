#pragma once
/// Exact numbers (p + e sqrt(q)) / s with whole p, q, s: abscissas where line segments and arcs of circles meet.

#include <array>
#include <cstdint>

#include "geometry/exact_segment.hpp"

namespace ligne::studies {

/// A whole number of at most kBits bits and a sign. Sums and products that would be longer are errors of the caller.
class WideInteger {
 public:
  static constexpr int kWords = 10, kBits = 32 * kWords;

  WideInteger() = default;
  WideInteger(Int128 value);  // implicit: every whole number is one

  int sign() const;
  WideInteger operator-() const;
  friend WideInteger operator+(const WideInteger& a, const WideInteger& b);
  friend WideInteger operator-(const WideInteger& a, const WideInteger& b) { return a + -b; }
  friend WideInteger operator*(const WideInteger& a, const WideInteger& b);

 private:
  using Words = std::array<std::uint32_t, kWords>;
  static int compare(const Words& a, const Words& b);

  Words words_{};  ///< magnitude, lowest word first
  bool is_negative_ = false;
};

/// Sign of d + e sqrt(q) + f sqrt(r); e and f are -1, 0 or 1, q and r not negative.
int sign_with_roots(const WideInteger& d, int e, const WideInteger& q, int f, const WideInteger& r);

/// (p + e sqrt(q)) / s with s > 0 and q >= 0; e is 0 for a quotient of whole numbers.
struct OneRoot {
  Int128 p = 0, q = 0, s = 1;
  int e = 0;

  OneRoot() = default;
  OneRoot(std::int64_t whole) : p(whole) {}  // implicit: every whole number is one
  /// Any sign of s but zero. Roots of squares become whole numbers.
  OneRoot(Int128 p, int e, Int128 q, Int128 s);

  double value() const;
  /// Sign of u x + v, where x is this number.
  int sign_of_linear(Int128 u, Int128 v) const;
  friend bool operator==(const OneRoot& a, const OneRoot& b) { return compare(a, b) == 0; }
  friend bool operator<(const OneRoot& a, const OneRoot& b) { return compare(a, b) < 0; }
  /// -1, 0, +1 if a is less than, equal to, greater than b. Exact for |p| < 2^48, q < 2^92 and s < 2^32; doubles decide
  /// most cases.
  static int compare(const OneRoot& a, const OneRoot& b);
};

}  // namespace ligne::studies
