#include "scene/model/precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ligne {
namespace {

/// Number of significant digits below which numbers count as written by hand: the default of printf's %g and of C++
/// streams.
constexpr int kFewestDigitsOfWriters = 6;

/// Half a unit in the last of `digits` binary digits of a number.
double half_ulp(double largest, int digits, int smallest_exponent) {
  if (largest == 0 || !std::isfinite(largest)) return 0;
  const int exponent = std::max(std::ilogb(largest) + 1, smallest_exponent);
  return std::ldexp(0.5, exponent - digits);
}

}  // namespace

int significant_digits(std::string_view word) {
  int digits = 0;
  bool fraction = false;
  for (const char c : word) {
    if (c == 'e' || c == 'E') {
      fraction = true;
      break;
    }
    if (c == '.') fraction = true;
    if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
  }
  return fraction ? digits : 0;
}

double half_ulp_float32(double largest) {
  using Float = std::numeric_limits<float>;
  return half_ulp(largest, Float::digits, Float::min_exponent);
}

double half_ulp_double(double largest) {
  using Double = std::numeric_limits<double>;
  return half_ulp(largest, Double::digits, Double::min_exponent);
}

void DecimalPrecision::add(int digits, double value) {
  largest_ = std::max(largest_, std::abs(value));
  most_digits_ = std::max(most_digits_, digits);
}

double DecimalPrecision::value() const {
  const double stored = half_ulp_double(largest_);
  if (largest_ == 0 || most_digits_ < kFewestDigitsOfWriters) return stored;
  const double exponent = std::floor(std::log10(largest_));
  return std::max(stored, 0.5 * std::pow(10.0, exponent + 1 - most_digits_));
}

}  // namespace ligne
