#pragma once
/// Checks the layers, materials and objects that pens and widths name against those of the drawing.

#include <set>
#include <string>

#include "drawing/drawing.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/page.hpp"

namespace ligne {

/// Returns the names of the drawing's layers.
std::set<std::string> layer_names(const Drawing& drawing);

/// Throws RequestError for a pen of a layer that neither this drawing nor any other drawing of the program has, and for
/// a pen of a material or object if the drawing names none. A drawing without lines has no names to compare with.
void check_pens(const PenTable& pens, const Drawing& drawing);

/// Phrases that list the named layers without lines, and the layers of the drawing; empty if there are none of the
/// former.
std::string absent_pen_layers(const PenTable& pens, const Drawing& drawing);
std::string absent_width_layers(const LineWidths& widths_mm, const Drawing& drawing);

}  // namespace ligne
