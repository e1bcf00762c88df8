#pragma once
/// Text in a typeface, through Cairo. Private to plotting.

#include <cairo.h>

#include <span>

#include "drawing/text_item.hpp"

namespace ligne {

/// The typeface of texts, and the first of the list that an SVG names. Cairo takes the nearest that the machine has.
inline constexpr const char* kTypeface = "DejaVu Sans";
/// Height of its capitals, as a fraction of the font size.
inline constexpr double kCapitalsOfSize = 1493.0 / 2048;

/// Writes the texts; the context's user space is page mm.
void write_texts(cairo_t* cairo, std::span<const TextItem> texts);

}  // namespace ligne
