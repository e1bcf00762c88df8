#pragma once
/// Cuts a drawing that is larger than the paper into several sheets.

#include <cstddef>
#include <vector>

#include "drawing/drawing.hpp"
#include "plotting/page.hpp"

namespace ligne {

/// One sheet: its part of the drawing, in its own page mm, with register marks and its number in a layer "register".
struct Tile {
  std::size_t number = 1;  ///< number among all sheets, row by row from the top left
  Drawing drawing;
};

/// Cuts a drawing on the page `whole` into sheets of `paper`, whose margins stay empty. Neighbouring sheets share a
/// strip `overlap_mm` wide, with register marks in its middle: the marks coincide if two sheets lie right. Sheets
/// without lines are left out. The margins and the overlap must leave a part of the paper.
std::vector<Tile> cut_into_tiles(const Drawing& drawing, const Page& whole, const Page& paper, double overlap_mm);

/// The parts of the lines inside the box; cut ends lie exactly on its sides.
Polylines clip_to_box(const Polylines& lines, const Rect& box);

}  // namespace ligne
