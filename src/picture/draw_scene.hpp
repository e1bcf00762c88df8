#pragma once
/// From a scene to its picture: what the command line and every other front end have in common.

#include <optional>

#include "picture/marks/axes.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "picture/scene_visibility.hpp"
#include "picture/write_picture.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Throws RequestError when parts of the request do not go together, or not with the method: gray faces and hatching with
/// the format, hatching and fills with what the method produces, margins with the page.
void check(const PictureRequest& request);

/// Draws a scene: study, hatching, fills, lines, and the file of the format that is asked for. `box` is what axes measure,
/// where the picture is a plot; `topology` that of the scene, where it is known; `pages`: see write_picture(). Counts, times
/// and warnings go to `run`. Throws RequestError, std::runtime_error.
Picture draw_scene(const Scene& scene, const PictureRequest& request, RunReport& run,
                   const std::optional<PlotBox>& box = std::nullopt, std::optional<Topology> topology = {},
                   PdfDocument* pages = nullptr);

}  // namespace ligne
