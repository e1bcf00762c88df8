#pragma once
/// Where beside a stroke nothing of its own object is seen.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contours/contour_strokes.hpp"
#include "linework/stroke.hpp"
#include "picture/requests.hpp"
#include "scene/model/scene.hpp"
#include "view/projected_scene.hpp"

namespace ligne {

/// A part of a stroke, by fractions of its length on the page.
struct FreePart {
  double from = 0, to = 1;
};

/// Parts of a stroke that end what is seen.
struct FreeParts {
  std::vector<FreePart> parts;  ///< in order and apart
  double off_mm = 0;            ///< how far beside the stroke was looked; contours are drawn beside their mesh
};

/// The kind of profile, and the width of the pen that draws it.
struct ProfileStyle {
  ProfileKind kind;
  double pen_width_mm;
};

/// Per stroke of `members` the parts beside which, on one side at least, lies the sheet, or what the kind says. Both close
/// beside the stroke, beyond all that counts as on it, and as far off as a gap is wide that its ink leaves open.
std::vector<FreeParts> free_parts(const StrokeModel& model, std::span<const std::uint32_t> members,
                                  const ProjectedScene& projected, const Scene& scene, const ContourSources& contours,
                                  const ProfileStyle& style);

}  // namespace ligne
