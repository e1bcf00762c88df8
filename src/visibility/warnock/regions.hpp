#pragma once
/// Joins the areas of all windows: one region for each visible connected part of a face, with its holes.
///
/// Where two trapezoids of one face meet along a line of constant u or v, their common border is removed and both join one
/// region. The remaining borders are closed contours: the border of each trapezoid is closed, and only pairs of opposite
/// segments are removed.

#include <vector>

#include "drawing/result_models.hpp"
#include "visibility/warnock/areas.hpp"

namespace ligne::warnock {

/// Regions by face, then in the order of the windows. Omits regions smaller than the square of `least_steps`. Outer contours
/// turn from x towards y on the page, holes the other way.
std::vector<Region> make_regions(const std::vector<AreaPiece>& pieces, const WindowFrame& frame, const Lattice& lattice,
                                 double least_steps);

}  // namespace ligne::warnock
