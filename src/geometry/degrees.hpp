#pragma once
/// Sine and cosine of angles in degrees, exact at whole multiples of 90, where those of radians are off by a rounding: pi is
/// none of the doubles.

#include <cmath>

namespace ligne {

struct SineCosine {
  double sine, cosine;
};

/// At whole multiples of 90 degrees 0, 1 and -1. The sine is odd and the cosine even, exactly. NaN for what is not finite.
inline SineCosine sine_cosine_degrees(double degrees) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  int quarters = 0;
  const double rest = std::remquo(degrees, 90.0, &quarters) * kDegree;  // exact, in [-45, 45]
  const double s = std::sin(rest), c = std::cos(rest);
  switch (quarters & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace ligne
