#pragma once
/// Puts the areas of all windows together: one region for each visible connected piece of a face, with its holes.
///
/// Where two trapezoids of one face meet along a line of constant u, or along a border of constant v, the common part goes
/// away and the two belong to one region. What is left are closed contours: every trapezoid's border is one, and only what
/// runs both ways is taken out.

#include <vector>

#include "drawing/result_models.hpp"
#include "view/projected_scene.hpp"
#include "visibility/warnock/areas.hpp"

namespace ligne::warnock {

/// Regions by face, then in the order of the windows. Those smaller than the square of `least_steps` are left out.
/// Outer contours turn as the page's axes do (from x towards y), holes the other way.
std::vector<Region> make_regions(const std::vector<AreaPiece>& pieces, const WindowFrame& frame, const Lattice& lattice,
                                 double least_steps);

}  // namespace ligne::warnock
