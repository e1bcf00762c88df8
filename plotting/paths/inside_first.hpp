#pragma once
/// Holes before the pieces that they are in: a cutter or a laser frees a piece when it draws the outer contour.

#include <cstdint>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne {

/// Changes an order of strokes so that every stroke inside a closed one is drawn before it; strokes inside one that is drawn
/// too early are taken along to it. A stroke lies inside where its first point does, and its box is the smaller one. Time:
/// n log n, and for each stroke the closed ones that reach over its height on the page.
std::vector<std::uint32_t> inside_first(const Polylines& lines, const std::vector<std::uint32_t>& order);

}  // namespace ligne
