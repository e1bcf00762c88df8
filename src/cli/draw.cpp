#include "cli/draw.hpp"

#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cli/culling.hpp"
#include "cli/option_helpers.hpp"
#include "cli/placement.hpp"
#include "cli/progress.hpp"
#include "cli/stages.hpp"
#include "plotting/output_file.hpp"
#include "plotting/writers.hpp"
#include "scene/topology.hpp"
#include "view/brightness.hpp"
#include "view/projected_scene.hpp"
#include "visibility/tolerances.hpp"

namespace ligne {
namespace {

constexpr double kLowestDpi = 1, kHighestDpi = 9600;
constexpr double kMostHatchLines = 1e6;
constexpr double kMmPerInch = 25.4;

constexpr const char* kExamples = R"(Examples:
  ligne draw gearbox.obj -o gearbox.svg
  ligne draw flange.glb --view front --scale 1:2 --unit m --hidden dashed --page A3 -o flange.pdf
  ligne draw tower.obj --eye 9,6,14 --fov 40 -q -o - --format svg | rsvg-convert -z 2 > tower.png)";

double parse_hatch_distance(const std::string& text) {
  const double mm = parse_length_mm(text);
  if (!(mm > 0)) throw std::invalid_argument("\"" + text + "\" is not a length above zero");
  return mm;
}

/// What the JSON drawing tells of an edge of the scene.
SourceEdge source_edge(const Scene& scene, const Edge& edge) {
  return {{scene.vertices[edge.v0], scene.vertices[edge.v1]}, {edge.face0, edge.face1}, false};
}

void check(const DrawOptions& options) {
  const OutputFormat format = format_of(options.output);
  check(options.page);
  if (options.shade && format != OutputFormat::png) throw UsageError("--shade", "gray faces are for PNG; see --hatch");
  if (options.hatch_mm && format == OutputFormat::json) throw UsageError("--hatch", "a JSON drawing has no hatching");
  if (options.shade && options.hatch_mm) throw UsageError("--hatch", "not together with --shade");
  if ((options.shade || options.hatch_mm) && !(method_of(options.method).traits().products & kSpans)) {
    throw UsageError(options.shade ? "--shade" : "--hatch", "needs a method that gives spans, such as --method watkins");
  }
  refuse_input_as_output("--output", *options.output.file, options.model.files);
  if (options.run.stats_json.empty()) return;
  refuse_input_as_output("--stats-json", options.run.stats_json, options.model.files);
  if (options.run.stats_json == *options.output.file) {
    throw UsageError("--stats-json", options.run.stats_json + " is the output file too");
  }
}

/// The scan lines that the drawing needs: one for each row of pixels, or those of the hatching.
std::optional<SpanLines> span_lines(const DrawOptions& options, const PlotOptions& plot) {
  if (options.shade) {
    const double row_mm = plot.page.height_mm / png_size(plot).height;
    return SpanLines{row_mm / 2, row_mm, png_size(plot).height};
  }
  if (!options.hatch_mm) return std::nullopt;
  const double count = std::ceil(plot.page.height_mm / *options.hatch_mm);
  if (count > kMostHatchLines) throw UsageError("--hatch", "the lines are too close: more than a million on the page");
  return SpanLines{*options.hatch_mm / 2, *options.hatch_mm, static_cast<std::uint32_t>(count)};
}

/// The method's study, with the progress bar over it.
VisibilityResult study(const DrawOptions& options, const Method& method, const ProjectedScene& projected, const PlotOptions& plot) {
  ProgressBar bar(options.run);
  StudyOptions study_options;
  study_options.hidden_strokes = options.method.hidden != HiddenLines::none;
  study_options.span_lines = span_lines(options, plot);
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

/// Faces as the light at the eye shows them, when they are asked for.
struct Surfaces {
  std::optional<GrayPicture> shaded;
  Polylines hatching;
};

Surfaces surfaces(const DrawOptions& options, const Scene& scene, const Camera& camera, const std::optional<SpanModel>& spans, const PlotOptions& plot) {
  Surfaces result;
  if (!spans || !(options.shade || options.hatch_mm)) return result;
  const std::vector<double> brightness = face_brightness(scene, camera);
  if (options.shade) {
    const PixelSize size = png_size(plot);
    result.shaded = shade(*spans, brightness, size.width, size.height, plot.dpi / kMmPerInch);
  } else {
    result.hatching = hatch(*spans, brightness, options.hatch_levels);
  }
  return result;
}

std::string written(OutputFormat format, const DrawingDocument& document, const PlotOptions& plot, Surfaces surfaces) {
  if (format == OutputFormat::json) return write_json(document, plot);
  Drawing drawing = make_drawing(*document.strokes);
  if (surfaces.hatching.size() > 0) drawing.layers.insert(drawing.layers.begin(), Layer{"hatch", std::move(surfaces.hatching)});
  if (document.debug) add_debug_layer(drawing, *document.debug);
  switch (format) {
    case OutputFormat::pdf:
      return write_pdf(drawing, plot);
    case OutputFormat::png:
      return write_png(drawing, plot, surfaces.shaded ? &*surfaces.shaded : nullptr);
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
  PlotOptions plot;
  plot.page = placement.page;
  plot.pen_width_mm = options.page.pen_width_mm;
  plot.hidden_solid = options.method.hidden == HiddenLines::solid;
  plot.title = options.title;
  plot.dpi = options.dpi;
  // Only the JSON drawing names the source edges; the study needs the memory of the rest.
  const std::vector<Edge> edges = format == OutputFormat::json ? std::move(topology.edges) : std::vector<Edge>{};
  topology = {};
  VisibilityResult result = timed(run.stages, "study", [&] { return study(options, method, projected, plot); });
  if (!result.strokes) throw UsageError("--method", std::string(method.traits().name) + " does not produce lines");
  StrokeModel& strokes = *result.strokes;

  if (!options.run.quiet) {
    if (strokes.strokes.empty()) {
      warn(place_of_warnings, "nothing to draw is in view: the drawing is empty");
    } else if (placement.larger_than_page()) {
      warn(place_of_warnings, "the picture is larger than the page: what lies outside is left out");
    }
  }

  timed(run.stages, "drawing", [&] { remove_coincident_strokes(strokes, coincidence_mm(projected)); });
  const std::string bytes = timed(run.stages, "write", [&] {
    DrawingDocument document;
    document.strokes = &strokes;
    document.regions = result.regions ? &*result.regions : nullptr;
    document.order = result.order ? &*result.order : nullptr;
    document.spans = result.spans ? &*result.spans : nullptr;
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
    return written(format, document, plot, surfaces(options, scene, placement.view.camera, result.spans, plot));
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
  draw->add_flag("--shade", options.shade, "PNG: faces in gray, lit from the eye (method with spans)")->group("Surfaces");
  add_parsed(*draw, "--hatch", "LEN", options.hatch_mm, [](const std::string& text) { return parse_hatch_distance(text); },
             "hatch the faces, the darkest with lines this far apart (method with spans)")
      ->group("Surfaces");
  add_parsed(*draw, "--hatch-levels", "N", options.hatch_levels, [](const std::string& text) { return parse_count(text, 1, kMostHatchLevels); },
             "degrees of darkness, 1 to 4")
      ->default_str("4")
      ->group("Surfaces");
  add_run_options(*draw, options.run);
  draw->footer(kExamples);
}

void run_draw(const DrawOptions& options) {
  check(options);
  run_with_threads(options.run, [&] { draw(options); });
}

}  // namespace ligne
