#pragma once
/// Faces in gray, lit from the eye.

#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/shading.hpp"
#include "picture/prepared_scene.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {

/// The scan lines that gray faces are made of, for PNG one for each row of pixels, and fills of a method that gives spans.
/// Nothing when no such faces are wanted, or lines as the method has them: pixels in vector files.
std::optional<SpanLines> gray_face_lines(const PictureRequest& request, const Method& method, const PlotOptions& plot);

/// Faces as a light at the eye shows them, as pixels: in PNG those of the page, in vector files those of the method, where
/// it gives pixels. Nothing when none are wanted, or areas stand for them.
std::optional<GrayPicture> gray_faces(const PreparedScene& prepared, const VisibilityResult& result,
                                      const PlotOptions& plot);

/// The gray faces as areas for vector files, by a method that gives spans; none otherwise.
std::vector<Fill> gray_areas(const PreparedScene& prepared, const VisibilityResult& result);

/// The fills that are asked for, as areas of the spans or pixels of the method (fills_spans()).
std::vector<Fill> filled_spans(const PreparedScene& prepared, const VisibilityResult& result);

}  // namespace ligne
