#pragma once
/// Faces in gray, lit from the eye.

#include <optional>

#include "drawing/shading.hpp"
#include "picture/scene_study.hpp"
#include "plotting/writers.hpp"

namespace ligne {

/// The scan lines that gray faces are made of, one for each row of pixels; nothing when none are wanted.
std::optional<SpanLines> gray_face_lines(const PictureRequest& request, const PlotOptions& plot);

/// Faces as a light at the eye shows them; nothing when none are wanted.
std::optional<GrayPicture> gray_faces(const PreparedScene& prepared, const VisibilityResult& result,
                                      const PlotOptions& plot);

}  // namespace ligne
