#pragma once
/// Joins tangent lines to contours that cross them from one surface into the other.
///
/// Where a cylinder runs into a fillet, as at the foot of a column, the contour of the cylinder crosses the tangent line
/// between both surfaces, or turns back there, and the visible part of that line begins at the crossing. The visibility
/// of the line is that of the mesh, so it begins at some vertex of the mesh beside that place.

#include <vector>

#include "contours/contour_junctions.hpp"
#include "contours/contour_lines.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// Leads free ends of visible tangent lines, on an edge at which a visible contour runs from one surface into another
/// (ContourNode::is_joint), to that place. The new strokes get sources in StrokeModel::intersections. `seen`: per chain of
/// `contours`.
void join_tangents_to_contours(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                               const std::vector<SeenContour>& seen);

}  // namespace ligne
