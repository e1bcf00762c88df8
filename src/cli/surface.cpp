#include "cli/surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "cli/models.hpp"
#include "cli/placement.hpp"
#include "cli/progress.hpp"
#include "cli/stages.hpp"
#include "cli/surface_mesh.hpp"
#include "cli/surface_samples.hpp"
#include "plotting/output_file.hpp"
#include "plotting/writers.hpp"
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

void draw(const SurfaceOptions& options) {
  RunReport run;
  run.method = "horizon";
  const Surface surface = timed(run.stages, "read", [&] { return std::move(surfaces_of(options).front()); });
  const HeightSource& heights = *surface.heights;
  const std::string place = place_of_warnings(options);

  HorizonOptions horizon;
  Placement placement;
  timed(run.stages, "place", [&] {
    const HeightSurvey found = survey(heights);
    horizon.holes = found.holes;
    horizon.z_scale = z_scale_of(options, heights, found);
    const Camera camera = camera_of(view_of(options), box_of(heights, found, horizon.z_scale));
    placement = ligne::place(stand_in(heights, horizon.z_scale, camera), camera, options.page);
  });
  horizon.outline = true;
  horizon.x_stride = surface.x_stride;
  horizon.y_stride = surface.y_stride;
  if (options.pixels) horizon.resolution = options.resolution.value_or(kResolution);
  Drawing drawing;
  timed(run.stages, "study", [&] {
    ProgressBar bar(options.run);
    if (bar.wanted()) horizon.progress = [&bar](double fraction) { bar.update(fraction); };
    HorizonLines lines = horizon_lines(heights, placement.view, horizon, run.study);
    const auto add = [&](const char* layer, Polylines& polylines) {
      if (polylines.size() > 0) drawing.layers.push_back({layer, std::move(polylines)});
    };
    add("horizon", lines.curves);
    add("outline", lines.outline);
  });
  if (!options.run.quiet) {
    if (drawing.layers.empty()) {
      warn(place, "nothing to draw is in view: the drawing is empty");
    } else if (placement.larger_than_page()) {
      warn(place, "the picture is larger than the page: what lies outside is left out");
    }
  }

  PlotOptions plot;
  plot.page = placement.page;
  plot.pen_width_mm = options.page.pen_width_mm;
  plot.title = options.title;
  plot.dpi = options.dpi;
  const OutputFormat format = format_of(options.output);
  const std::string bytes = timed(run.stages, "write", [&] {
    return format == OutputFormat::pdf   ? write_pdf(drawing, plot)
           : format == OutputFormat::png ? write_png(drawing, plot)
                                         : write_svg(drawing, plot);
  });
  timed(run.stages, "output", [&] { write_output(*options.output.file, bytes); });
  if (options.run.stats) std::fputs(report_text(run).c_str(), stderr);
  if (!options.run.stats_json.empty()) write_output(options.run.stats_json, report_json(run));
}

}  // namespace

void setup_surface(CLI::App& app, SurfaceOptions& options) { add_surface_command(app, options); }

void run_surface(const SurfaceOptions& options) {
  check(options);
  run_with_threads(options.run, [&] { drawn_by_horizon(options) ? draw(options) : run_surface_mesh(options); });
}

}  // namespace ligne
