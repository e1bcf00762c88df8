#pragma once
/// Profiles: the parts of lines behind which an object ends, and the sheet, or another object farther back, is seen.
/// docs/profiles.md.

#include "contours/contour_strokes.hpp"
#include "linework/stroke.hpp"
#include "picture/requests.hpp"
#include "scene/model/scene.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// Gives these parts of the visible strokes of edges class profile; to be called when every line is there once. `contours`:
/// what draw_contours() gave.
void draw_profiles(StrokeModel& model, const ProjectedScene& projected, const Scene& scene, const ContourSources& contours,
                   ProfileKind kind, double pen_width_mm);

}  // namespace ligne
