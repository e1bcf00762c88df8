#pragma once
/// The tolerances of the page that all methods share; docs/numerics.md derives them.

#include "view/projected_scene.hpp"

namespace ligne {

/// A drawing owes its coordinates to one micrometre. Differences below a quarter of it are noise: lines so close
/// are one line, and a piece of a line so short, cut off by a crossing, is dropped.
inline constexpr double kLeastPartMm = 0.00025;

/// Lines that lie within this distance of each other on the page are one line: a quarter of a micrometre, or what the
/// error of the input's coordinates moves two lines by.
inline double coincidence_mm(const ProjectedScene& scene) {
  const double limit = 0.001;  // never more than the accuracy of the drawing
  const double input = 2 * scene.input_error_mm;
  return kLeastPartMm + (input < limit - kLeastPartMm ? input : limit - kLeastPartMm);
}

}  // namespace ligne
