#pragma once
/// The intersections of clear lines.

#include "linework/stroke.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// Leaves out the strokes of intersections where two surfaces only touch: a pin in its bore, a ball in its race, whose
/// triangles pass through each other all over. Faces touch where they lie within each other's distance from the shape that
/// they stand for (chord_errors.hpp). Where surfaces that do intersect are tangent in places, their line stays whole. What
/// runs along a rim goes there (rim_lines.hpp). Counted in `run`. Does nothing for exact lines. docs/clear-lines.md,
/// "Contacts".
void clear_intersections(StrokeModel& model, const Scene& scene, const ProjectedScene& projected, const LineRequest& request,
                         RunReport& run);

}  // namespace ligne
