#pragma once
/// Finds the parts of strokes beside which their own object is not visible.

#include <array>
#include <cstdint>
#include <vector>

#include "contours/contour_strokes.hpp"
#include "linework/stroke.hpp"
#include "linework/stroke_geometry.hpp"
#include "picture/requests.hpp"
#include "scene/model/scene.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// The parts of a stroke at which the visible object ends.
struct FreeParts {
  std::vector<StrokePart> parts;  ///< sorted and disjoint
  double off_mm = 0;              ///< distance of the tested line; contours are drawn beside their mesh
};

/// The kind of profile, and the width of the pen that draws it.
struct ProfileStyle {
  ProfileKind kind;
  double pen_width_mm;
};

/// Returns for each visible stroke of an edge the parts with the paper, or another object as the kind says, on at least one
/// side. It must be visible both close to the stroke, beyond the tolerance of coincident lines, and at the distance of
/// the narrowest gap that ink leaves open.
std::vector<FreeParts> free_parts(const StrokeModel& model, const ProjectedScene& projected, const Scene& scene,
                                  const ContourSources& contours, const ProfileStyle& style);

}  // namespace ligne
