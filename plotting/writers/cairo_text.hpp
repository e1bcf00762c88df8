#pragma once
/// Text in a typeface, through Cairo. Private to plotting.

#include <cairo.h>

#include <span>

#include "drawing/text_item.hpp"

namespace ligne {

/// The typeface: the first choice, and what an SVG names besides. Cairo takes the nearest that the machine has.
inline constexpr const char* kTypeface = "DejaVu Sans";
/// Height of its capitals by size of the font.
inline constexpr double kCapitalsOfSize = 1493.0 / 2048;

/// Writes the texts; the context's user space is page mm.
void write_texts(cairo_t* cairo, std::span<const TextItem> texts);

}  // namespace ligne
