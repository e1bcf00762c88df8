#pragma once
/// From a scene to its picture. The command line and every other front end call these functions.

#include <optional>

#include "picture/drawn_scene.hpp"
#include "picture/marks/axes.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// Computes the lines, areas and hatching of a scene. The scene must outlive the result.
/// - `box`: the range that the axes measure, if the picture is a plot with axes.
/// - `topology`: the topology of the scene if the caller has it already; otherwise it is built.
/// - `keep_edges`: keeps the source edges of strokes even if the requested format does not need them.
///
/// Counts, times and warnings go to `run`. Throws RequestError.
DrawnScene draw_lines(const Scene& scene, PictureRequest request, RunReport& run,
                      const std::optional<PlotBox>& box = std::nullopt, std::optional<Topology> topology = {},
                      bool keep_edges = false);

/// Draws a scene and returns the bytes of a file in the requested format. The arguments are those of draw_lines(), plus
/// `pages` of write_picture(). Throws RequestError, std::runtime_error.
Picture draw_scene(const Scene& scene, const PictureRequest& request, RunReport& run,
                   const std::optional<PlotBox>& box = std::nullopt, std::optional<Topology> topology = {},
                   PdfDocument* pages = nullptr);

}  // namespace ligne
