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
/// - decimals: some programs round coordinates to a few decimals, and then write few digits or store float32. Where all
///   coordinates of an object lie on one decimal grid, and evidently were rounded to it, the precision is at least half a
///   step of the grid.
///
/// A precision is never below half a unit in the last place of a double, the type in which coordinates are stored.

#include <span>
#include <string_view>

#include "geometry/point.hpp"

namespace ligne {

/// Half a unit in the last place of a float32, and of a double, at a coordinate of absolute value `largest`.
double half_ulp_float32(double largest);
double half_ulp_double(double largest);

/// Half a step of the decimal grid (0.1, 0.01, ..., or twice or five times that) to which the coordinates were rounded; 0
/// if there is none. They may have moved by some roundings of a float32 since. They were rounded if there are many, the
/// grid is fine against their extent, and their last decimals are spread evenly: those of a part drawn on a grid are not.
double decimal_grid(std::span<const Point3> positions);

/// Number of significant digits of a number as written; 0 for whole numbers and zeros. Leading zeros do not count,
/// trailing zeros do.
int significant_digits(std::string_view word);

/// Derives the precision of one object from its coordinates as written. If they have more digits than a float32, and all of
/// them are those of float32 numbers, it is that of float32: most programs keep such coordinates.
class DecimalPrecision {
 public:
  /// Adds a coordinate: `word` is the text of the number, `value` its value.
  void add(std::string_view word, double value) { add(significant_digits(word), value); }
  void add(int digits, double value);
  /// The precision, model units.
  double value() const;

 private:
  void check_float32(int digits, double value);

  double largest_ = 0;
  int most_digits_ = 0;
  bool may_be_float32_ = true;
  int float32_numbers_ = 0;
};

}  // namespace ligne
