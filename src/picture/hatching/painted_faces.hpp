#pragma once
/// Grey faces, lit from the eye.

#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/shading.hpp"
#include "picture/prepared_scene.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {

/// The scan lines of grey faces, and of fills with a method that returns spans. For PNG there is one for each row of
/// pixels. None if no such faces are requested, or if the method decides on the lines (pixels in vector files).
std::optional<SpanLines> gray_face_lines(const PictureRequest& request, const Method& method, const PlotOptions& plot);

/// Makes PreparedScene::tones if grey faces of continuous tone are requested; the scene still has its topology.
void prepare_tones(PreparedScene& prepared);

/// Grey faces as pixels, lit from the eye: pixels of the page in PNG, pixels of the method in vector files. None if
/// none are requested, or if areas replace them. Continuous tone is always an image.
std::optional<GrayPicture> gray_faces(const PreparedScene& prepared, const VisibilityResult& result,
                                      const PlotOptions& plot);

/// Grey faces as areas, for vector files and a method that returns spans; otherwise none.
std::vector<Fill> gray_areas(const PreparedScene& prepared, const VisibilityResult& result);

/// The requested fills as areas, from the spans or pixels of the method (fills_spans()).
std::vector<Fill> filled_spans(const PreparedScene& prepared, const VisibilityResult& result);

}  // namespace ligne
