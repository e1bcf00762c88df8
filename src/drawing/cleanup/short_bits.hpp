#pragma once
/// Bits of lines, and gaps in them, too short on the page to be seen as such.

#include <cstddef>

#include "drawing/stroke.hpp"

namespace ligne {

/// Closes the gaps between visible strokes of one source that are shorter than `gap_mm`: hidden strokes in them become
/// visible; where there are no hidden strokes at all, new ones fill them. To be called before remove_coincident_strokes().
/// Returns their number. O(n log n).
std::size_t close_short_gaps(StrokeModel& model, double gap_mm);

/// Hides visible strokes that continue each other, end at no end of another line, and are together shorter than `least_mm`,
/// when visibility cuts off at least one of their ends, or all of them are intersections: those of shapes end at edges.
/// Short edges and small features stay, since they are whole. Where there are no hidden strokes they are left out. No two
/// visible strokes coincide. Returns the number of such bits. O(n).
std::size_t drop_short_bits(StrokeModel& model, double least_mm);

}  // namespace ligne
