#pragma once
/// Closes gaps in lines that are too short on the page to be seen.

#include <cstddef>

#include "linework/stroke.hpp"

namespace ligne {

/// Closes the gaps between visible strokes of one source that are shorter than `gap_mm`. Hidden strokes in a gap become
/// visible; in a drawing without hidden strokes new ones fill the gap. Call it before remove_coincident_strokes().
/// Returns the number of gaps closed. O(n log n).
std::size_t close_short_gaps(StrokeModel& model, double gap_mm);

}  // namespace ligne
