#pragma once
/// Object::precision: how far a coordinate can be from what its writer meant.
///
/// The rule, in one place:
/// - float32 files: half a unit in the last place of a float32 at the object's largest coordinate;
/// - double files: the same of a double;
/// - text: writers that compute print a fixed number of significant digits (%g: 6) or decimals (%f: 6), and drop trailing
///   zeros or not. The most significant digits S that any number of the object has, at its largest coordinate of decimal
///   exponent E, give half a unit of the digit 10^(E + 1 - S). For fixed decimals that is the last decimal, for fixed
///   digits the last digit of the largest coordinate. Numbers with a few digits (0.5, 12.25) are written by people, who
///   mean what they write, and so are whole numbers: such objects have the precision of a double.
/// A precision is never below half a unit in the last place of a double, since that is how coordinates are stored.

#include <string_view>

namespace ligne {

/// Half a unit in the last place of a float32, of a double, at a coordinate of that size.
double half_ulp_float32(double largest);
double half_ulp_double(double largest);

/// Significant digits of a number as written; 0 for whole numbers and zeros. Leading zeros do not count, trailing ones do.
int significant_digits(std::string_view word);

/// Collects what the coordinates of one object say about their precision.
class DecimalPrecision {
 public:
  /// `word` is the number as written, `value` what it means.
  void add(std::string_view word, double value) { add(significant_digits(word), value); }
  void add(int digits, double value);
  double value() const;

 private:
  double largest_ = 0;
  int most_digits_ = 0;
};

}  // namespace ligne
