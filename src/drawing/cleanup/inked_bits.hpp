#pragma once
/// Short pieces of lines that do not show as such beside the lines that they touch.

#include <cstddef>

#include "drawing/stroke.hpp"

namespace ligne {

/// Gives runs of one class (drawing/graphs/stroke_lines.hpp) that are shorter than `least_mm` the class of the longest run
/// that continues them, when that is longer: the class of a rim, decided edge by edge, changes to and fro where it is seen
/// along its plane. Edges of class mesh neither give nor take. No two visible strokes coincide. Returns the number of runs.
/// O(n).
std::size_t join_short_classes(StrokeModel& model, double least_mm);

struct InkLimits {
  double longest_mm = 0;  ///< runs shorter than this may be bits
  double ink_mm = 0;      ///< how far the ink of a line reaches to either side
  double shown_mm = 0;    ///< a bit of which less lies outside of the ink of other lines does not show
};

/// Hides runs, or takes them out where no stroke is hidden, that are short and do not show beside the ink of longer ones:
/// spurs beside outlines, edges seen end on, rungs between lines that nearly touch. No two visible strokes coincide. Returns
/// their number; bits that end where others end count together. O(n + m), with m the grid cells of the side of `ink_mm` x 2
/// that lines pass near the bits.
std::size_t drop_inked_bits(StrokeModel& model, const InkLimits& limits);

}  // namespace ligne
