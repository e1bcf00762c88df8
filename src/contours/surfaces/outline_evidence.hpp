#pragma once
/// Contours held against the visibility of the mesh's own outline.
///
/// A contour is studied beside the mesh (contour_sights.hpp), where a line of sight may pass something that hides the mesh
/// itself, or meet what does not. So the edges that gave way are studied too, and say what is seen of the contour beside
/// them.

#include <vector>

#include "contours/contour_junctions.hpp"
#include "contours/contour_lines.hpp"

namespace ligne {

/// Lengths on the page, mm. Parts up to the shortest one stay as they are, but for visible ones longer than the clear one
/// with no visible edge within as much more.
struct EvidenceSizes {
  double shortest_mm, clear_mm;
};

/// Hides visible runs of contours where an edge of the mesh's outline beside them is hidden and none is seen. Where the
/// solid is hollow at an edge, the mesh hides its own outline by a hair, so such edges testify only against runs beside
/// which nothing of the outline is seen. Shows hidden runs where an edge beside them is seen and no visible contour stands
/// for it. Beside: within ContourNode::most_mm. `edges`: strokes of the edges themselves, sorted as by take_strokes().
void hold_against_outlines(std::vector<SeenContour>& seen, const SmoothContours& contours, const View& view,
                           const Lattice& lattice, const std::vector<Stroke>& edges, const EvidenceSizes& sizes);

}  // namespace ligne
