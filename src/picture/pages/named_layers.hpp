#pragma once
/// Layers, materials and objects that pens and widths name, held against those of the drawing.

#include <set>
#include <string>

#include "drawing/drawing.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/page.hpp"

namespace ligne {

/// The names of the drawing's layers.
std::set<std::string> layer_names(const Drawing& drawing);

/// Throws RequestError for a pen of a layer that neither the drawing nor any drawing of ours has, and for a pen of a
/// material or object of a drawing that tells none. A drawing without lines has no names to compare with.
void check_pens(const PenTable& asked, const Drawing& drawing);

/// A phrase that lists the layers which pens or widths name and no line is in, and the layers of the drawing; empty where
/// there is nothing to say.
std::string absent_pen_layers(const PenTable& asked, const Drawing& drawing);
std::string absent_width_layers(const LineWidths& widths_mm, const Drawing& drawing);

}  // namespace ligne
