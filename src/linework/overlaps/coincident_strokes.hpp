#pragma once
/// Removes all but one of the lines that lie on each other.

#include "linework/stroke.hpp"

namespace ligne {

/// Makes every line appear once. Where strokes lie on each other within `tolerance_mm`, only the one with the highest
/// precedence stays: visible before hidden, seen directly before seen through transparent faces, then by class, then
/// the nearer one, then the lower source. Two strokes are compared only if `needs_overlap_check` is true for at least
/// one. Strokes without overlap keep their order; the others follow by precedence.
void remove_coincident_strokes(StrokeModel& model, double tolerance_mm);

}  // namespace ligne
