#pragma once
/// Where two segments of the page lie on each other.

#include <optional>

#include "linework/stroke_geometry.hpp"

namespace ligne {

/// The common interval of two segments, as fractions of each. At an end of it that is not an end of a, `b_...` is exactly
/// 0 or 1, and the other way round.
struct StrokeOverlap {
  double a_from, a_to;  ///< on a, a_from < a_to
  double b_from, b_to;  ///< the fractions of b at the same places; b_from > b_to when b runs the other way
};

/// Projects the shorter segment onto the line of the longer one. The two coincide when the interval that they have in
/// common there is longer than the tolerance and the shorter deviates from that line by at most the tolerance at both ends
/// of it. So a wedge, two segments that leave one point at an angle however small, does not coincide unless it closes
/// again within the tolerance. `tolerance` in lattice steps.
std::optional<StrokeOverlap> overlap(LatticePoint a0, LatticePoint a1, LatticePoint b0, LatticePoint b1, double tolerance);

}  // namespace ligne
