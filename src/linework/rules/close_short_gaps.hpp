#pragma once
/// Gaps in lines that are too short on the page to be seen.

#include <cstddef>

#include "linework/stroke.hpp"

namespace ligne {

/// Closes the gaps between visible strokes of one source that are shorter than `gap_mm`: hidden strokes in them become
/// visible; where there are no hidden strokes at all, new ones fill them. To be called before remove_coincident_strokes().
/// Returns their number. O(n log n).
std::size_t close_short_gaps(StrokeModel& model, double gap_mm);

}  // namespace ligne
