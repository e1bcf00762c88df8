#include "picture/draw_scene.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "picture/clear/refined_picture.hpp"
#include "picture/hatching/hatching.hpp"
#include "picture/hatching/painted_faces.hpp"
#include "plotting/stroke_text.hpp"

namespace ligne {
namespace {

/// Writes the debug numbers of the method as polylines of the debug layer.
void write_debug_numbers(VisibilityResult& result, const PictureRequest& request, const Page& page) {
  if (result.debug_numbers.empty()) return;
  const double height_mm = text_height_mm(request.axes, page);
  for (const PageNumber& n : result.debug_numbers) {
    Polylines lines;
    append_stroke_text({std::to_string(n.number), n.middle, height_mm, TextAcross::center, TextUp::middle}, lines);
    for (std::size_t i = 0; i + 1 < lines.begin.size(); ++i) {
      result.debug.emplace_back(lines.points.begin() + lines.begin[i], lines.points.begin() + lines.begin[i + 1]);
    }
  }
  result.debug_numbers.clear();
}

}  // namespace

DrawnScene draw_lines(const Scene& scene, PictureRequest request, RunReport& run, const std::optional<PlotBox>& box,
                      std::optional<Topology> topology, bool keep_edges) {
  check(request);
  DrawnParts parts{prepare(scene, std::move(request), box, run, std::move(topology)), {}};
  PreparedScene& prepared = parts.prepared;
  SceneVisibility& found = parts.found;
  const PlotOptions plot = plot_options(prepared.request, prepared.around.placement.page);
  prepare_tones(prepared);
  HatchScene hatch = hatch_scene(prepared, plot);
  parts.hatching = hatch_spans(hatch, run);
  parts.has_edges = keep_edges || looks_at_edges(prepared.request);
  found = compute_visibility(prepared, painted_lines(prepared.request, prepared.method, plot), parts.has_edges, run);
  const bool asks_for_ellipses =
      plot.curves && !prepared.circles.empty() && prepared.request.output.format != OutputFormat::json;
  // The rules that finish lines leave threads idle.
  parallel_tasks(asks_for_ellipses ? 2 : 1, [&](std::size_t task) {
    if (task == 0) {
      finish_lines(found, prepared, run);
    } else {
      parts.ellipses = known_ellipses(prepared);
    }
  });
  write_debug_numbers(found.result, prepared.request, prepared.around.placement.page);
  if (found.result.regions) {
    std::ranges::move(hatch_regions(hatch, *found.result.regions, run), std::back_inserter(parts.hatching));
  }
  parts.patches = std::move(hatch.patches);
  prepared.projected = {};
  prepared.request.progress = {};
  return DrawnScene(on_given_scene(std::move(parts)));
}

Picture draw_scene(const Scene& scene, const PictureRequest& request, RunReport& run, const std::optional<PlotBox>& box,
                   std::optional<Topology> topology, PdfDocument* pages) {
  return draw_lines(scene, request, run, box, std::move(topology)).write(run, pages);
}

}  // namespace ligne
