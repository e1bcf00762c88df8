#pragma once
/// Joins tangent lines to contours that turn back between two surfaces.
///
/// Where a cylinder runs into a hollow fillet, as at the foot of a column, the contour of the cylinder ends on the
/// tangent line between both surfaces, and the visible part of that line begins there. The visibility of the line is
/// that of the mesh, so it begins at some vertex of the mesh beside that place.

#include <vector>

#include "contours/contour_junctions.hpp"
#include "contours/contour_lines.hpp"
#include "linework/stroke.hpp"

namespace ligne {

/// Leads free ends of visible tangent lines, on an edge on which a visible contour turns back (ContourNode::corner), to
/// that place. The new strokes get sources in StrokeModel::intersections. `seen`: per chain of `contours`.
void join_tangents_at_corners(StrokeModel& model, const Scene& scene, const View& view, const SmoothContours& contours,
                              const std::vector<SeenContour>& seen);

}  // namespace ligne
