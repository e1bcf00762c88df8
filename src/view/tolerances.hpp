#pragma once
/// The tolerances of the page that all methods share; docs/numerics.md derives them.

#include "view/projected_scene.hpp"

namespace ligne {

/// Length on the page, mm, below which differences are noise: a quarter of a micrometre, where the accuracy of a
/// drawing is one micrometre. Lines this close to each other are one line, and a piece of a line this short between two
/// crossings is dropped.
inline constexpr double kLeastPartMm = 0.00025;

/// Distance on the page, mm, within which two lines are one line: a quarter of a micrometre plus twice the error of the
/// input coordinates, at most one micrometre.
inline double coincidence_mm(const ProjectedScene& scene) {
  const double limit = 0.001;  // the accuracy of the drawing, mm
  const double input = 2 * scene.input_error_mm;
  return kLeastPartMm + (input < limit - kLeastPartMm ? input : limit - kLeastPartMm);
}

}  // namespace ligne
