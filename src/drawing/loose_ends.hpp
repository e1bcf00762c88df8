#pragma once
/// Ends of lines between which nothing shows.

#include <cstddef>
#include <functional>

#include "drawing/stroke.hpp"

namespace ligne {

/// Where a stroke of no edge comes from, whose source is still that of the line that it belongs to.
using MakeSource = std::function<SourceEdge(const Stroke&)>;

/// Joins lines of which each ends nearest to the end of the other, less than `gap_mm` away and on its way (it turns by no
/// more than 60 degrees), where no other line ends: a stroke between the two ends is added, with a source of its own.
/// Nothing is added to the mesh's own lines. No two visible strokes coincide. Returns the number of such strokes. O(n).
std::size_t join_loose_ends(StrokeModel& model, double gap_mm, const MakeSource& make_source);

}  // namespace ligne
