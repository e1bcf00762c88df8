#pragma once
/// Corrects the visibility of contours by that of the mesh's own outline.
///
/// The visibility of a contour is computed on lines beside the mesh (contour_sights.hpp). An occluder of the mesh may
/// miss these lines, and something else may hide them. So the visibility of the replaced edges is computed too, and
/// overrules that of the contour beside them.

#include <vector>

#include "contours/contour_junctions.hpp"
#include "contours/contour_lines.hpp"

namespace ligne {

<<<<<<< HEAD
/// Lengths on the page, mm. Parts up to the shortest one stay as they are, but for visible ones longer than the clear one
/// with no visible edge within as much more.
struct EvidenceSizes {
  double shortest_mm, clear_mm;
};

/// Hides visible runs of contours where an edge of the mesh's outline beside them is hidden and none is seen. Where the
/// solid is hollow at an edge, the mesh hides its own outline by a hair, so such edges testify only against runs beside
/// which nothing of the outline is seen. Shows hidden runs where an edge beside them is seen and no visible contour stands
/// for it. Beside: within ContourNode::most_mm. `edges`: strokes of the edges themselves, sorted as by take_strokes().
=======
/// Changes runs of contours by the replaced edges beside them, which are those within ContourNode::most_mm:
/// - Hides a visible part if an edge beside it is hidden and none is visible. At a concave edge the mesh hides its own
///   outline by a hair, so concave edges count only for runs beside which no edge is visible.
/// - Makes a hidden part visible if an edge beside it is visible and no visible contour stands for that edge.
///
/// Parts of up to `shortest_mm` do not change, except visible ones longer than `clear_mm` that have no visible edge
/// within `clear_mm` more than that distance either. `edges`: the strokes of the replaced edges, sorted as by
/// take_strokes().
>>>>>>> 8c25e621 (Explain contours in the terms of their page)
void hold_against_outlines(std::vector<SeenContour>& seen, const SmoothContours& contours, const View& view,
                           const Lattice& lattice, const std::vector<Stroke>& edges, const EvidenceSizes& sizes);

}  // namespace ligne
