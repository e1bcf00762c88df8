#pragma once
/// Cuts dashed lines into strokes, since plotters have no dash attributes.

#include <span>

#include "drawing/drawing.hpp"

namespace ligne {

/// Cuts lines into dashes as in ISO 128-2. Each line begins and ends with a dash; the whole pattern is scaled slightly
/// for that. A line shorter than dash, gap and dash stays one dash. `dashes_mm` are the lengths of dash, gap, dash, gap
/// ... as seen on paper. The round tip of a pen of `pen_width_mm` makes a drawn stroke longer by its width, so the
/// strokes are shorter by that width, but at least a dot. If there are no dashes, the lines do not change.
Polylines cut_dashes(const Polylines& lines, std::span<const double> dashes_mm, double pen_width_mm);

/// Shortest pattern that is cut, page mm. A shorter one would be invisible and make a huge number of strokes; the line
/// then stays whole.
inline constexpr double kShortestPatternMm = 1e-3;

/// Cuts lines by exactly this pattern, starting `offset_mm` into it. An odd number of lengths is repeated, as in SVG.
Polylines cut_pattern(const Polylines& lines, std::span<const double> lengths_mm, double offset_mm);

}  // namespace ligne
