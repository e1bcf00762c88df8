#pragma once
/// Cuts in lines that cost more than they spare. Private to plotting/paths.

#include <cstdint>
#include <span>

#include "linework/stroke.hpp"

namespace ligne {

/// `whole` are the segments of lines, numbered by source in their order, those of line i from line_begin[i] on; the model
/// holds what others left of them, by source and parameter. A piece that is missing between two that stay is put back when
/// it is shorter than `lift_mm` and its two ends are loose, so that a lift is spared: when an odd number of strokes meets in
/// either, and they are not the two ends of one chain. The shortest first. Returns whether any was put back; they stand at
/// the end of the model. Time O(n log n).
bool bridge_cuts(std::span<const Stroke> whole, std::span<const std::uint32_t> line_begin, double lift_mm,
                 StrokeModel& model);

}  // namespace ligne
