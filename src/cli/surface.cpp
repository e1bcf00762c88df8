#include "cli/surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/models.hpp"
#include "cli/plotter_output.hpp"
#include "cli/progress.hpp"
#include "cli/scene_drawing.hpp"
#include "cli/stages.hpp"
#include "cli/surface_mesh.hpp"
#include "cli/surface_samples.hpp"
#include "plotting/writers.hpp"
#include "scene/surfaces/height_filters.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne {
namespace {

constexpr unsigned kResolution = 2000;

/// The factor by which heights take half of the larger side of the ground.
double z_scale_of(const SurfaceOptions& options, const HeightSource& heights, const HeightSurvey& survey) {
  if (options.z_scale) return *options.z_scale;
  if (survey.empty()) return 1;
  const double height = survey.high - survey.low;
  const double side = std::max(heights.x().back() - heights.x().front(), heights.y().back() - heights.y().front());
  const double scale = side / (2 * height);
  return height > 0 && std::isfinite(scale) ? scale : 1;
}

/// Adds the ground at a height.
void add_rectangle(Scene& scene, const HeightSource& heights, double z) {
  const auto first = static_cast<std::uint32_t>(scene.vertices.size());
  for (const double y : {heights.y().front(), heights.y().back()}) {
    for (const double x : {heights.x().front(), heights.x().back()}) scene.vertices.push_back({x, y, z});
  }
  scene.faces.add_triangle(first, first + 1, first + 2);
  scene.faces.add_triangle(first + 1, first + 3, first + 2);
}

/// What the horizon draws of a surface, and where.
struct HorizonRequest {
  HorizonOptions options;
  Camera camera;
  Scene extent;          ///< what the page must hold
  HeightSurvey heights;  ///< what a box round it spans, before scaling
};

/// A ridgeline plot is as high as this part of its width, and seen as high as its rows are lifted.
constexpr double kRidgelineHeight = 1.2;
const Point3 kRidgelineSight{0, 1, -1};

/// Changes the heights into those of a ridgeline plot, where one is wanted.
HorizonRequest request_of(const SurfaceOptions& options, Surface& surface) {
  HorizonRequest request;
  HorizonOptions& horizon = request.options;
  horizon.x_stride = surface.x_stride;
  horizon.y_stride = surface.y_stride;
  if (options.pixels) horizon.resolution = options.resolution.value_or(kResolution);
  horizon.underside = options.curves.underside;
  horizon.hidden_by = options.curves.hidden_by;
  horizon.outline = options.curves.outline.value_or(horizon.hidden_by == HiddenBy::surface);

  HeightSurvey found = survey(*surface.heights);
  horizon.holes = found.holes;
  ViewOptions view = view_of(options);
  if (options.curves.ridgeline) {
    const double rows = options.curves.ridgeline_overlap * static_cast<double>(std::max<std::size_t>(surface.y_stride, 1));
    surface.heights = ridgeline_heights(std::move(surface.heights), found.low, found.high, rows, kRidgelineHeight);
    found = survey(*surface.heights);
    view.direction = kRidgelineSight;
    horizon.hidden_by = HiddenBy::curves;
    horizon.underside = Underside::none;
    horizon.outline = false;
  } else {
    horizon.z_scale = z_scale_of(options, *surface.heights, found);
  }

  const HeightSource& heights = *surface.heights;
  request.camera = camera_of(view, box_of(heights, found, horizon.z_scale));
  request.extent = stand_in(heights, horizon.z_scale, request.camera);
  request.heights = found;
  if (found.empty()) return request;
  horizon.contours = contour_levels(options.curves, found.low, found.high);
  horizon.contours_on_surface = options.curves.contours || options.curves.contour_step;
  if (options.curves.contours_base) {
    horizon.contour_base = contour_base_of(options.curves, found.low, found.high);
    add_rectangle(request.extent, heights, *horizon.contour_base * horizon.z_scale);
    request.heights.low = std::min(found.low, *horizon.contour_base);
    request.heights.high = std::max(found.high, *horizon.contour_base);
  }
  return request;
}

std::optional<PlotBox> plot_box(const HeightSource& heights, const HeightSurvey& found, double z_scale) {
  if (found.empty()) return std::nullopt;
  return PlotBox{
      {{heights.x().front(), heights.y().front(), found.low}, {heights.x().back(), heights.y().back(), found.high}},
      z_scale};
}

/// What the study saw of the axes' lines.
Polylines axes_of(const HorizonLines& lines, const Surroundings& around) {
  std::vector<std::vector<VisibleInterval>> seen(lines.back_lines.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (const horizon::Span& span : lines.back_lines[i]) seen[i].push_back({span.from, span.to});
  }
  return lines_of_axes(around, seen);
}

Drawing drawing_of(HorizonLines& lines) {
  Drawing drawing;
  const auto add = [&](const char* layer, Polylines& polylines) {
    if (polylines.size() > 0) drawing.layers.push_back({layer, std::move(polylines)});
  };
  add("contour-base", lines.base_contours);
  add("underside", lines.underside);
  add("horizon", lines.curves);
  add("contour", lines.contours);
  add("border", lines.border);
  add("outline", lines.outline);
  return drawing;
}

void draw(const SurfaceOptions& options, RunFiles& files) {
  const OutputFormat format = format_of(options.output);
  const PlotterSetup plotter = plotter_setup(options.plotter, format, files);
  RunReport run;
  run.method = "horizon";
  Surface surface = timed(run.stages, "read", [&] { return std::move(surfaces_of(options, files).front()); });
  HorizonRequest request;
  Surroundings around;
  timed(run.stages, "place", [&] {
    request = request_of(options, surface);
    around = place_with_axes(plot_box(*surface.heights, request.heights, request.options.z_scale), request.extent,
                             request.camera, options.page, options.axes, options.title);
    request.options.back_lines = back_lines(around);
  });
  HorizonLines lines;
  timed(run.stages, "study", [&] {
    ProgressBar bar(options.run);
    if (bar.wanted()) request.options.progress = [&bar](double fraction) { bar.update(fraction); };
    lines = horizon_lines(*surface.heights, around.placement.view, request.options, run.study);
  });
  Drawing drawing = drawing_of(lines);
  if (!options.run.quiet) {
    if (drawing.layers.empty()) {
      warn(place_of_warnings(options), "nothing to draw is in view: the drawing is empty");
    } else if (around.placement.larger_than_page()) {
      warn(place_of_warnings(options), "the picture is larger than the page: what lies outside is left out");
    }
  }

  if (Polylines axes = axes_of(lines, around); axes.size() > 0) drawing.layers.push_back({"axes", std::move(axes)});
  const std::size_t unknown = add_surroundings(drawing, around, options.axes);
  if (unknown > 0 && !options.run.quiet)
    warn(place_of_warnings(options), std::to_string(unknown) + " characters are not in the font: drawn as boxes");

  PlotOptions plot;
  plot.page = around.placement.page;
  plot.pen_width_mm = options.page.pen_width_mm;
  plot.title = options.title;
  plot.dpi = options.dpi;
  std::string bytes = timed(run.stages, "write", [&] { return written(drawing, plot, plotter, format, files, run); });
  timed(run.stages, "output", [&] { files.write(*options.output.file, std::move(bytes)); });
  finish(options.run, run, files);
}

}  // namespace

void setup_surface(CLI::App& app, SurfaceOptions& options) { add_surface_command(app, options); }

void run_surface(const SurfaceOptions& options) {
  check(options);
  RunFiles files;
  files.will_write("--output", *options.output.file);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--stats-json", options.run.stats_json);
  run_with_threads(options.run,
                   [&] { drawn_by_horizon(options) ? draw(options, files) : run_surface_mesh(options, files); });
}

}  // namespace ligne
