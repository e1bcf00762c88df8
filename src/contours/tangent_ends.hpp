#pragma once
/// Ends tangent lines on the contours that they run into.
///
/// A tangent line that passes from the front of a surface to its back is visible up to the contour of the surface. A
/// node of the contour on an edge of the line is that place. The visibility of the line is that of the mesh, however:
/// the line ends at a vertex before or behind the contour. On the page both lines touch there, so the end may lie some
/// facets away, but no farther beside the contour than the sag of the mesh.

#include <vector>

#include "contours/contour_junctions.hpp"
#include "contours/contour_lines.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// Leads a free end of a visible tangent line to the visible contour that crosses the line next to it, or cuts the line
/// there. All that is added or cut lies within ContourNode::most_mm of the contour. Ends that touch a visible line stay.
/// New strokes get sources in StrokeModel::intersections. `seen`: per chain of `contours`.
void end_tangents_on_contours(StrokeModel& model, const View& view, const SmoothContours& contours,
                              const std::vector<SeenContour>& seen, const Scene& scene);

}  // namespace ligne
