#pragma once
/// Text as single strokes, with the letters that A. V. Hershey drew for pen plotters (plotting/fonts/), and sizes of
/// texts.

#include <cstddef>
#include <string_view>

#include "drawing/drawing.hpp"

namespace ligne {

enum class TextStyle {
  font,    ///< written in a sans serif typeface
  stroke,  ///< drawn as lines
};

/// The size of a line of text. For a typeface it is computed with the widths of DejaVu Sans, whatever typefaces a
/// machine has, so that a drawing is the same everywhere; other typefaces are usually narrower.
TextExtent text_extent(std::string_view utf8, double height_mm, TextStyle style);

/// Adds the lines of a text. A character that the font lacks is drawn as a box. Returns the number of boxes.
std::size_t append_stroke_text(const TextItem& item, Polylines& lines);

/// Turns all texts of the drawing into lines of a layer "text", behind all other layers. Returns the number of
/// characters drawn as a box.
std::size_t draw_texts_as_strokes(Drawing& drawing);

}  // namespace ligne
