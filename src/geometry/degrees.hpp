#pragma once
/// Sine and cosine of angles in degrees. They are exact at whole multiples of 90, where the functions of radians are
/// off by a rounding because no double equals pi.

#include <cmath>

namespace ligne {

struct SineCosine {
  double sine, cosine;
};

/// 0, 1 or -1 at whole multiples of 90 degrees. The sine is odd and the cosine even, exactly. NaN if `degrees` is not
/// finite.
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
