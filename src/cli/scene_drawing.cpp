#include "cli/scene_drawing.hpp"

#include <cstdio>
#include <utility>

#include "cli/culling.hpp"
#include "cli/errors.hpp"
#include "cli/models.hpp"
#include "cli/placement.hpp"
#include "cli/progress.hpp"
#include "plotting/output_file.hpp"
#include "plotting/writers.hpp"
#include "scene/topology.hpp"
#include "view/projected_scene.hpp"
#include "visibility/atherton_weiler/details.hpp"
#include "visibility/atherton_weiler/shadows.hpp"
#include "visibility/tolerances.hpp"

namespace ligne {
namespace {

/// What the JSON drawing tells of an edge of the scene.
SourceEdge source_edge(const Scene& scene, const Edge& edge) {
  return {{scene.vertices[edge.v0], scene.vertices[edge.v1]}, {edge.face0, edge.face1}, false};
}

/// The method's study, with the progress bar over it.
VisibilityResult study(const SceneDrawing& request, const ProjectedScene& projected) {
  ProgressBar bar(request.run);
  StudyOptions study_options;
  study_options.hidden_strokes = request.hidden != HiddenLines::none;
  study_options.settings = request.settings;
  if (bar.wanted()) study_options.progress = [&bar](double fraction) { bar.update(fraction); };
  return request.method.study(projected, study_options);
}

/// Below all lines.
void add_debug_layer(Drawing& drawing, const std::vector<std::vector<Point2>>& polylines) {
  Layer layer{"debug", {}};
  for (const std::vector<Point2>& line : polylines) {
    layer.lines.points.insert(layer.lines.points.end(), line.begin(), line.end());
    layer.lines.begin.push_back(static_cast<std::uint32_t>(layer.lines.points.size()));
  }
  drawing.layers.insert(drawing.layers.begin(), std::move(layer));
}

std::string written(OutputFormat format, const DrawingDocument& document, const PlotOptions& plot, std::vector<Fill> fills, Polylines hatching) {
  if (format == OutputFormat::json) return write_json(document, plot);
  Drawing drawing = make_drawing(*document.strokes);
  if (document.debug) add_debug_layer(drawing, *document.debug);
  drawing.fills = std::move(fills);
  if (hatching.size() > 0) drawing.layers.insert(drawing.layers.begin(), {"hatch", std::move(hatching)});
  switch (format) {
    case OutputFormat::pdf:
      return write_pdf(drawing, plot);
    case OutputFormat::png:
      return write_png(drawing, plot);
    default:
      return write_svg(drawing, plot);
  }
}

}  // namespace

void draw_scene(const Scene& scene, const SceneDrawing& request, RunReport& run) {
  run.method = request.method.traits().name;
  const OutputFormat format = format_of(request.output);
  Topology topology = timed(run.stages, "topology", [&] { return build_topology(scene); });

  Placement placement;
  const ProjectedScene projected = timed(run.stages, "project", [&] {
    placement = place(scene, camera_of(request.view, scene), request.page);
    ProjectedScene all = project(scene, topology, placement.view, {request.classes, request.crease_degrees});
    if (request.cull) cull_back_faces(scene, topology, all, request.place_of_warnings, request.run.quiet);
    return all;
  });
  // Only the JSON drawing names the source edges; the study needs the memory of the rest.
  const std::vector<Edge> edges = format == OutputFormat::json ? std::move(topology.edges) : std::vector<Edge>{};
  const std::vector<Light> lights = lights_of(request.fill, scene);
  topology = {};
  VisibilityResult result = timed(run.stages, "study", [&] { return study(request, projected); });
  if (!result.strokes) throw UsageError("--method", std::string(request.method.traits().name) + " does not produce lines");
  StrokeModel& strokes = *result.strokes;
  if (request.fill.asked() && !result.regions) {
    throw UsageError(request.fill.kind == FillKind::none ? "--light" : "--fill",
                     std::string(request.method.traits().name) + " does not produce regions; atherton-weiler does");
  }
  if (result.regions && !scene.details.empty()) *result.regions = atherton_weiler::cut_details(scene, placement.view, std::move(*result.regions));
  if (!lights.empty() && result.regions) {
    timed(run.stages, "shadows", [&] {
      *result.regions = atherton_weiler::cast_shadows(scene, build_topology(scene), placement.view, lights, *result.regions);
    });
  }

  if (!request.run.quiet) {
    if (strokes.strokes.empty()) {
      warn(request.place_of_warnings, "nothing to draw is in view: the drawing is empty");
    } else if (placement.larger_than_page()) {
      warn(request.place_of_warnings, "the picture is larger than the page: what lies outside is left out");
    }
  }

  PlotOptions plot;
  plot.page = placement.page;
  plot.pen_width_mm = request.page.pen_width_mm;
  plot.hidden_solid = request.hidden == HiddenLines::solid;
  plot.title = request.title;
  plot.dpi = request.dpi;
  timed(run.stages, "drawing", [&] { remove_coincident_strokes(strokes, coincidence_mm(projected)); });
  const std::string bytes = timed(run.stages, "write", [&] {
    DrawingDocument document;
    document.strokes = &strokes;
    document.regions = result.regions ? &*result.regions : nullptr;
    document.order = result.order ? &*result.order : nullptr;
    document.debug = result.debug.empty() ? nullptr : &result.debug;
    document.source = [&](std::uint32_t source) {
      return source < strokes.edge_count ? source_edge(scene, edges.at(source))
                                         : strokes.intersections.at(source - strokes.edge_count);
    };
    document.model_to_page = placement.view.model_to_page;
    document.perspective = placement.view.camera.perspective;
    document.window = placement.view.window;
    document.near_distance = placement.view.near_distance;
    document.method = run.method;
    document.statistics = result.statistics;
    std::vector<Fill> fills;
    Polylines hatching;
    if (result.regions && request.fill.kind == FillKind::hatch) {
      hatching = hatch_regions(scene, placement.view, *result.regions, lights, plot.pen_width_mm);
    } else if (result.regions && request.fill.kind != FillKind::none) {
      fills = fill_regions(scene, placement.view, *result.regions, lights, request.fill.kind);
    }
    return written(format, document, plot, std::move(fills), std::move(hatching));
  });
  run.study = std::move(result.statistics);
  timed(run.stages, "output", [&] { write_output(*request.output.file, bytes); });
  report(request.run, run);
}

void report(const RunOptions& options, const RunReport& run) {
  if (options.stats) std::fputs(report_text(run).c_str(), stderr);
  if (!options.stats_json.empty()) write_output(options.stats_json, report_json(run));
}

}  // namespace ligne
