#pragma once
/// Text as single strokes, with the letters that A. V. Hershey drew for pen plotters (plotting/fonts/), and the room that
/// texts take.

#include <cstddef>
#include <string_view>

#include "drawing/drawing.hpp"

namespace ligne {

enum class TextStyle {
  font,    ///< written in a sans serif typeface
  stroke,  ///< drawn as lines
};

/// The room that a line of text takes. That of a typeface is reckoned with widths of DejaVu Sans, whatever this or another
/// machine has, so that a drawing is the same everywhere; other typefaces are narrower as a rule.
TextExtent text_extent(std::string_view utf8, double height_mm, TextStyle style);

/// Adds the lines of a text. A character that the font lacks is drawn as a box. Returns the number of these.
std::size_t append_stroke_text(const TextItem& item, Polylines& lines);

/// All texts of the drawing become lines of the layer "text", the last of the layers. Returns the number of characters drawn
/// as a box.
std::size_t draw_texts_as_strokes(Drawing& drawing);

}  // namespace ligne
