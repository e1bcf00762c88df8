#pragma once
/// Draws holes before the pieces around them: a cutter or a laser frees a piece when it draws the outer contour.

#include <cstdint>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne {

/// Changes an order of strokes so that every stroke inside a closed one is drawn before it. Inner strokes that come
/// later move to just before the closed stroke. A stroke is inside if its first point is, and its bounding box is
/// smaller. Time: O(n log n), plus for each stroke the closed strokes whose boxes reach over the height of its first
/// point.
std::vector<std::uint32_t> inside_first(const Polylines& lines, const std::vector<std::uint32_t>& order);

}  // namespace ligne
