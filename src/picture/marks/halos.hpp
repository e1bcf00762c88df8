#pragma once
/// Keeps labels readable on coloured areas.

#include <span>

#include "drawing/drawing.hpp"
#include "plotting/stroke_text.hpp"

namespace ligne {

/// Sets labels off from the areas of the drawing, if it has any: letters of a typeface by a halo of paper colour, single
/// strokes, which can not have one, by a white area that is added to the drawing.
void set_off_from_fills(Drawing& drawing, std::span<TextItem> labels, TextStyle style);

}  // namespace ligne
