#pragma once
/// Profiles: the parts of lines behind which an object ends, so that the paper or an object farther back is visible.
/// docs/profiles.md.

#include "contours/contour_strokes.hpp"
#include "linework/stroke.hpp"
#include "picture/requests.hpp"
#include "scene/model/scene.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// Gives these parts of the visible strokes of edges the class profile. Call it after coincident strokes are removed.
/// `contours` is the result of draw_contours().
void draw_profiles(StrokeModel& model, const ProjectedScene& projected, const Scene& scene, const ContourSources& contours,
                   ProfileKind kind, double pen_width_mm);

}  // namespace ligne
