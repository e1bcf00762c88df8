#pragma once
/// Dashed lines as strokes of their own: plotters know no dash attributes.

#include <span>

#include "drawing/drawing.hpp"

namespace ligne {

/// Cuts lines into dashes of the ISO 128-2 kind: each line begins and ends with a dash, for which the pattern is stretched
/// or pressed a little as a whole; a line shorter than a dash, a gap and a dash stays one dash. `dashes_mm` are the lengths
/// of dash, gap, dash, gap ... as they are to be seen on paper; the round tip of a pen of `pen_width_mm` lengthens what it
/// draws by its width, so the strokes are shorter by that, and never shorter than a dot. Without dashes the lines stay.
Polylines cut_dashes(const Polylines& lines, std::span<const double> dashes_mm, double pen_width_mm);

/// A pattern shorter than this can not be seen, and would make strokes without end: the line stays whole.
inline constexpr double kShortestPatternMm = 1e-3;

/// Cuts lines by exactly this pattern, which begins `offset_mm` into it; an odd number of lengths is repeated, as SVG does.
Polylines cut_pattern(const Polylines& lines, std::span<const double> lengths_mm, double offset_mm);

}  // namespace ligne
