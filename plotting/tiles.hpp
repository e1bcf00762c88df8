#pragma once
/// A drawing that is larger than the paper, on several sheets.

#include <cstddef>
#include <vector>

#include "drawing/drawing.hpp"
#include "plotting/page.hpp"

namespace ligne {

/// One sheet: what of the drawing lies on it, in its own page mm, with register marks and its number in a layer "register".
struct Tile {
  std::size_t number = 1;  ///< of all sheets, row by row from the top left
  Drawing drawing;
};

/// Cuts a drawing on the page `whole` into sheets of `paper`, of which the margins stay empty. Neighbours have a strip
/// `overlap_mm` wide in common; where two sheets lie right, their marks, in the middle of the strips, do. Sheets on which
/// nothing is drawn are left out. The margins and the overlap must leave something of the paper.
std::vector<Tile> cut_into_tiles(const Drawing& drawing, const Page& whole, const Page& paper, double overlap_mm);

/// The lines inside the box, exactly along its sides.
Polylines clip_to_box(const Polylines& lines, const Rect& box);

}  // namespace ligne
