#pragma once
/// Corrects the visibility of contours by the visibility of the mesh's own outline.
///
/// The visibility of a contour is computed on lines beside the mesh (contour_sights.hpp). An occluder of the mesh may
/// miss these lines, and something else may hide them. So the visibility of the replaced edges is computed too, and
/// overrules the visibility of the contour beside them.

#include <vector>

#include "contours/contour_junctions.hpp"
#include "contours/contour_lines.hpp"

namespace ligne {

/// Lengths on the page, mm. Parts up to `shortest_mm` long do not change, except visible parts longer than `clear_mm`
/// without a visible edge within ContourNode::most_mm plus `clear_mm`.
struct EvidenceSizes {
  double shortest_mm, clear_mm;
};

/// Changes runs of contours by the replaced edges beside them, which are those within ContourNode::most_mm:
/// - Hides a visible part if an edge beside it is hidden and none is visible. At a concave edge the mesh hides its own
///   outline by a hair, so concave edges count only for runs beside which no edge is visible.
/// - Makes a hidden part visible if an edge beside it is visible and no visible contour stands for that edge.
/// `edges`: strokes of the edges themselves, sorted as by take_strokes().
void hold_against_outlines(std::vector<SeenContour>& seen, const SmoothContours& contours, const View& view,
                           const Lattice& lattice, const std::vector<Stroke>& edges, const EvidenceSizes& sizes);

}  // namespace ligne
