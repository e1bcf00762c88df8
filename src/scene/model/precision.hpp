#pragma once
/// Object::precision: bound on the difference between a stored coordinate and the exact value before it was written.
///
/// The rules:
/// - float32 files: half a unit in the last place of a float32 at the object's largest coordinate;
/// - double files: half a unit in the last place of a double there;
/// - text: programs print a fixed number of significant digits (%g: 6) or of decimals (%f: 6), with or without trailing
///   zeros. Let S be the largest number of significant digits of any number of the object, and E the decimal exponent
///   of its largest coordinate. The precision is half of 10^(E + 1 - S). For fixed decimals that is half the last
///   decimal, for fixed digits half the last digit of the largest coordinate. Numbers with few digits (0.5, 12.25) and
///   whole numbers are assumed to be exact: such objects have the precision of a double.
///
/// A precision is never below half a unit in the last place of a double, the type in which coordinates are stored.

#include <string_view>

namespace ligne {

/// Half a unit in the last place of a float32, and of a double, at a coordinate of absolute value `largest`.
double half_ulp_float32(double largest);
double half_ulp_double(double largest);

/// Number of significant digits of a number as written; 0 for whole numbers and zeros. Leading zeros do not count,
/// trailing zeros do.
int significant_digits(std::string_view word);

/// Derives the precision of one object from its coordinates as written.
class DecimalPrecision {
 public:
  /// Adds a coordinate: `word` is the text of the number, `value` its value.
  void add(std::string_view word, double value) { add(significant_digits(word), value); }
  void add(int digits, double value);
  /// The precision, model units.
  double value() const;

 private:
  double largest_ = 0;
  int most_digits_ = 0;
};

}  // namespace ligne
