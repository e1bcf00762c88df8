#pragma once
/// Faces painted from the spans or pixels of a method: grey, lit from the eye, or in the colours of fills.

#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/raster/shading.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {

/// The scan lines of painted faces with a method that returns spans. For an image there is one for each row of pixels.
/// None if no such faces are requested, or if the method decides on the lines (pixels in vector files).
std::optional<SpanLines> painted_lines(const PictureRequest& request, const Method& method, const PlotOptions& plot);

/// Makes PreparedScene::tones if faces of continuous tone are requested; the scene still has its topology.
void prepare_tones(PreparedScene& prepared);

/// Painted faces as an image: grey ones as pixels of the page in PNG, as pixels of the method in vector files; of
/// continuous tone, gray or in colour, in every file. None if none are requested, or if areas replace them.
std::optional<FacePicture> face_picture(const PreparedScene& prepared, const VisibilityResult& result,
                                        const PlotOptions& plot);

/// Grey faces as areas, for vector files and a method that returns spans; otherwise none.
std::vector<Fill> gray_areas(const PreparedScene& prepared, const VisibilityResult& result);

/// The requested fills as areas, from the spans or pixels of the method (fills_spans()).
std::vector<Fill> filled_spans(const PreparedScene& prepared, const VisibilityResult& result);

}  // namespace ligne
