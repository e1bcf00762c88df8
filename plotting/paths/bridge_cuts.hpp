#pragma once
/// Puts back removed pieces of lines whose removal costs more time than it saves. Private to plotting/paths.

#include <cstdint>
#include <span>

#include "linework/stroke.hpp"

namespace ligne {

/// `whole` holds the segments of lines, numbered by source in order; line i begins at line_begin[i]. The model holds
/// the parts of them that stay, sorted by source and parameter. A missing piece between two parts that stay is put back
/// if it is shorter than `lift_mm` and saves a lift: an odd number of strokes meets at both its ends, and they are not
/// the two ends of one chain. The shortest pieces come first. Returns whether any piece was put back; these stand at
/// the end of the model. Time O(n log n).
bool bridge_cuts(std::span<const Stroke> whole, std::span<const std::uint32_t> line_begin, double lift_mm,
                 StrokeModel& model);

}  // namespace ligne
