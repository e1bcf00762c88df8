#pragma once
/// Contours held against the visibility of the mesh's own outline.
///
/// A contour is studied beside the mesh (contour_sights.hpp), where a line of sight may pass something that hides the mesh
/// itself. So the edges that gave way are studied too, and a contour is not seen where those beside it are hidden.

#include <vector>

#include "contours/contour_junctions.hpp"
#include "contours/contour_lines.hpp"

namespace ligne {

/// Hides visible runs of contours where an edge of the mesh's outline beside them is hidden and none is seen. Beside: within
/// ContourNode::most_mm. Where the solid is hollow at an edge, the mesh hides its own outline by a hair, so such edges
/// testify only against runs beside which nothing of the outline is seen. Hidden parts up to `shortest_mm` stay visible.
/// `edges`: strokes of the edges themselves, sorted as by take_strokes().
void hide_behind_outlines(std::vector<SeenContour>& seen, const SmoothContours& contours, const View& view,
                          const Lattice& lattice, const std::vector<Stroke>& edges, double shortest_mm);

}  // namespace ligne
