#include "cli/draw.hpp"

#include <cstdio>
#include <optional>
#include <utility>

#include "cli/culling.hpp"
#include "cli/option_helpers.hpp"
#include "cli/placement.hpp"
#include "cli/progress.hpp"
#include "cli/stages.hpp"
#include "plotting/output_file.hpp"
#include "plotting/writers.hpp"
#include "scene/topology.hpp"
#include "view/projected_scene.hpp"
#include "visibility/tolerances.hpp"

namespace ligne {
namespace {

constexpr double kLowestDpi = 1, kHighestDpi = 9600;

constexpr const char* kExamples = R"(Examples:
  ligne draw gearbox.obj -o gearbox.svg
  ligne draw flange.glb --view front --scale 1:2 --unit m --hidden dashed --page A3 -o flange.pdf
  ligne draw tower.obj --eye 9,6,14 --fov 40 -q -o - --format svg | rsvg-convert -z 2 > tower.png)";

/// What the JSON drawing tells of an edge of the scene.
SourceEdge source_edge(const Scene& scene, const Edge& edge) {
  return {{scene.vertices[edge.v0], scene.vertices[edge.v1]}, {edge.face0, edge.face1}, false};
}

void check(const DrawOptions& options) {
  format_of(options.output);
  check(options.page);
  refuse_input_as_output("--output", *options.output.file, options.model.files);
  if (options.run.stats_json.empty()) return;
  refuse_input_as_output("--stats-json", options.run.stats_json, options.model.files);
  if (options.run.stats_json == *options.output.file) {
    throw UsageError("--stats-json", options.run.stats_json + " is the output file too");
  }
}

/// The method's study, with the progress bar over it.
VisibilityResult study(const DrawOptions& options, const Method& method, const ProjectedScene& projected) {
  ProgressBar bar(options.run);
  StudyOptions study_options;
  study_options.hidden_strokes = options.method.hidden != HiddenLines::none;
  study_options.settings = settings_of(options.method, method);
  if (bar.wanted()) study_options.progress = [&bar](double fraction) { bar.update(fraction); };
  return method.study(projected, study_options);
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

std::string written(OutputFormat format, const DrawingDocument& document, const PlotOptions& plot) {
  if (format == OutputFormat::json) return write_json(document, plot);
  Drawing drawing = make_drawing(*document.strokes);
  if (document.debug) add_debug_layer(drawing, *document.debug);
  switch (format) {
    case OutputFormat::pdf:
      return write_pdf(drawing, plot);
    case OutputFormat::png:
      return write_png(drawing, plot);
    default:
      return write_svg(drawing, plot);
  }
}

void report(const RunOptions& options, const RunReport& run) {
  if (options.stats) std::fputs(report_text(run).c_str(), stderr);
  if (!options.stats_json.empty()) write_output(options.stats_json, report_json(run));
}

void draw(const DrawOptions& options) {
  const Method& method = method_of(options.method);
  settings_of(options.method, method);  // a wrong one is told before anything is read
  const OutputFormat format = format_of(options.output);
  const std::string& place_of_warnings = options.model.files.front();
  RunReport run;
  run.method = method.traits().name;

  const LoadedModels models = timed(run.stages, "read", [&] { return load_models(options.model, options.run.quiet); });
  const Scene& scene = models.scene;
  Topology topology = timed(run.stages, "topology", [&] { return build_topology(scene); });

  Placement placement;
  const ProjectedScene projected = timed(run.stages, "project", [&] {
    placement = place(scene, camera_of(options.view, scene), options.page);
    ProjectedScene all = project(scene, topology, placement.view, {options.method.edges, options.method.crease_degrees});
    if (options.method.cull) cull_back_faces(scene, topology, all, place_of_warnings, options.run.quiet);
    return all;
  });
  // Only the JSON drawing names the source edges; the study needs the memory of the rest.
  const std::vector<Edge> edges = format == OutputFormat::json ? std::move(topology.edges) : std::vector<Edge>{};
  topology = {};
  VisibilityResult result = timed(run.stages, "study", [&] { return study(options, method, projected); });
  if (!result.strokes) throw UsageError("--method", std::string(method.traits().name) + " does not produce lines");
  StrokeModel& strokes = *result.strokes;

  if (!options.run.quiet) {
    if (strokes.strokes.empty()) {
      warn(place_of_warnings, "nothing to draw is in view: the drawing is empty");
    } else if (placement.larger_than_page()) {
      warn(place_of_warnings, "the picture is larger than the page: what lies outside is left out");
    }
  }

  PlotOptions plot;
  plot.page = placement.page;
  plot.pen_width_mm = options.page.pen_width_mm;
  plot.hidden_solid = options.method.hidden == HiddenLines::solid;
  plot.title = options.title;
  plot.dpi = options.dpi;
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
    return written(format, document, plot);
  });
  run.study = std::move(result.statistics);
  timed(run.stages, "output", [&] { write_output(*options.output.file, bytes); });
  report(options.run, run);
}

}  // namespace

void setup_draw(CLI::App& app, DrawOptions& options) {
  CLI::App* draw = app.add_subcommand("draw", "Hidden-line drawing of meshes and polygon scenes");
  add_model_options(*draw, options.model);
  add_view_options(*draw, options.view);
  add_method_options(*draw, options.method);
  add_page_options(*draw, options.page);
  add_output_options(*draw, options.output);
  add_parsed(
      *draw, "--dpi", "N", options.dpi,
      [](const std::string& text) { return parse_within(text, kLowestDpi, kHighestDpi, "dots per inch"); },
      "resolution of a PNG")
      ->default_str("150")
      ->group("Output");
  draw->add_option("--title", options.title, "title of an SVG or PDF")->type_name("TEXT")->group("Output");
  add_run_options(*draw, options.run);
  draw->footer(kExamples);
}

void run_draw(const DrawOptions& options) {
  check(options);
  run_with_threads(options.run, [&] { draw(options); });
}

}  // namespace ligne
