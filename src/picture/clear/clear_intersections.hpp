#pragma once
/// Removes intersections that clear lines do not draw.

#include "linework/stroke.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "scene/patches/find_patches.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// Removes the strokes of intersections where two surfaces only touch. The triangles of a pin in its bore or a ball in
/// its race, for example, penetrate each other everywhere. Faces touch where their distance is within the errors of
/// both faces (chord_errors.hpp); `patches` are the recognised surfaces of the scene, if any. Intersections along a rim move
/// onto the rim (rim_lines.hpp). Counts the changes in `run`. Does nothing for exact lines. docs/clear-lines.md, "Contacts".
void clear_intersections(StrokeModel& model, const Scene& scene, const ProjectedScene& projected, const LineRequest& request,
                         const Patches& patches, RunReport& run);

}  // namespace ligne
