#pragma once
/// The common interval of two segments of the page.

#include <optional>

#include "linework/stroke_geometry.hpp"

namespace ligne {

/// The common interval of two segments, as fractions of each. At an end of the interval that is not an end of a, the
/// fraction of b is exactly 0 or 1, and vice versa.
struct StrokeOverlap {
  double a_from, a_to;  ///< on a, a_from < a_to
  double b_from, b_to;  ///< the fractions of b at the same places; b_from > b_to if b runs the other way
};

/// Segments longer than this are long, in tolerances. Adjustable.
inline constexpr double kLongInTolerances = 64;
/// Largest difference of direction at which two long segments coincide (stroke_directions::difference()). At a larger one
/// they share at most 60 tolerances, near an end of each: too little to be seen.
inline constexpr double kDirectionReach = 1.0 / 15;

/// Projects the shorter segment onto the line of the longer one. The two coincide if their common interval there is
/// longer than the tolerance and the shorter segment is within the tolerance of that line at both ends of the interval.
/// So a wedge (two segments that leave one point at an angle, however small) does not coincide unless it closes again
/// within the tolerance. Two long segments coincide only if their directions differ by at most kDirectionReach.
/// `tolerance` is in lattice steps.
std::optional<StrokeOverlap> overlap(LatticePoint a0, LatticePoint a1, LatticePoint b0, LatticePoint b1, double tolerance);

}  // namespace ligne
