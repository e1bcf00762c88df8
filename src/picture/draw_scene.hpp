#pragma once
/// From a scene to its picture: what the command line and every other front end have in common.

#include <optional>

#include "picture/check_request.hpp"
#include "picture/drawn_scene.hpp"
#include "picture/marks/axes.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The lines, areas and hatching of a scene, which must outlive them. `box` is what axes measure, where the picture is a
/// plot; `topology` that of the scene, where it is known; with `keep_edges` the sources of strokes are known whatever the
/// format. Counts, times and warnings go to `run`. Throws RequestError.
DrawnScene draw_lines(const Scene& scene, PictureRequest request, RunReport& run,
                      const std::optional<PlotBox>& box = std::nullopt, std::optional<Topology> topology = {},
                      bool keep_edges = false);

/// Draws a scene and writes the file of the format that is asked for; arguments as for draw_lines(). `pages`: see
/// write_picture(). Throws RequestError, std::runtime_error.
Picture draw_scene(const Scene& scene, const PictureRequest& request, RunReport& run,
                   const std::optional<PlotBox>& box = std::nullopt, std::optional<Topology> topology = {},
                   PdfDocument* pages = nullptr);

}  // namespace ligne
