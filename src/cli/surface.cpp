#include "cli/surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "cli/models.hpp"
#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "cli/progress.hpp"
#include "cli/stages.hpp"
#include "cli/surface_axes.hpp"
#include "cli/text.hpp"
#include "plotting/output_file.hpp"
#include "plotting/writers.hpp"
#include "scene/height_source.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne {
namespace {

constexpr double kLowestDpi = 1, kHighestDpi = 9600;
constexpr unsigned kMostCurves = 20'000, kMostSamples = 1'000'000, kHighestResolution = 1'000'000;
constexpr unsigned kCurves = 40;
constexpr double kAzimuth = -60, kElevation = 30;
/// Samples between two neighbouring curves when nothing is said: smooth, but no more than a thousand along a curve for its own sake.
constexpr unsigned kSamplesBetween = 5, kSamplesAlong = 1000;
constexpr unsigned kResolution = 2000;

constexpr const char* kExamples = R"help(Examples:
  ligne surface "sin(r)/r" -x -12:12:60 -y -12:12:60 -o sombrero.svg
  ligne surface --grid terrain.asc --every 2 --z-scale 2 --azimuth 30 -o terrain.pdf
  ligne surface "sin(x*y)" -x -3:3 -y -3:3 --lines x --eye 8,-6,5 --pen-width 0.2 -o waves.svg)help";

/// "A:B" or "A:B:N".
CurveRange parse_range(const std::string& text) {
  const std::size_t first = text.find(':');
  if (first == std::string::npos) throw std::invalid_argument("\"" + text + "\" is not A:B or A:B:N");
  const std::size_t second = text.find(':', first + 1);
  CurveRange range;
  range.from = parse_number(text.substr(0, first));
  range.to = parse_number(text.substr(first + 1, second == std::string::npos ? second : second - first - 1));
  if (second != std::string::npos) range.curves = parse_count(text.substr(second + 1), 2, kMostCurves);
  if (!(range.from < range.to)) throw std::invalid_argument("the range " + text + " does not ascend");
  if (!std::isfinite(range.to - range.from)) throw std::invalid_argument("the range " + text + " is too large");
  return range;
}

void check(const SurfaceOptions& options) {
  if (options.formula.empty() == options.grid.empty()) {
    throw UsageError("surface: give a formula in x and y, or --grid FILE" + std::string(options.grid.empty() ? "" : ", not both"));
  }
  const OutputFormat format = format_of(options.output);
  if (format == OutputFormat::json) throw UsageError("--format", "a surface is written as svg, pdf or png");
  check(options.page);
  check(options.axes);
  if (!options.grid.empty()) {
    if (options.x || options.y) throw UsageError("-x, -y", "a grid has its own positions; --every N says which curves are drawn");
    if (options.samples) throw UsageError("--samples", "a grid has its own samples");
    refuse_input_as_output("--output", *options.output.file, std::span(&options.grid, 1));
  } else if (options.every) {
    throw UsageError("--every", "goes with --grid; a formula has its number of curves in -x A:B:N");
  }
  if ((options.azimuth_degrees || options.elevation_degrees) && options.view_given) {
    throw UsageError("--azimuth, --elevation", "do not go with --view, --direction or --eye");
  }
  if (options.resolution && !options.pixels) throw UsageError("--resolution", "goes with --horizon pixels");
}

/// Positions of the samples, and every how many there is a curve.
struct Positions {
  std::vector<double> at;
  std::size_t stride = 1;
};

/// `crossed`: whether curves run along this axis and need samples between those of the other family.
Positions positions(const std::optional<CurveRange>& given, bool crossed, const std::optional<unsigned>& samples) {
  const CurveRange range = given.value_or(CurveRange{});
  const unsigned intervals = range.curves.value_or(kCurves) - 1;
  Positions result;
  if (crossed && samples) {
    result.stride = std::max(1u, (*samples - 1 + intervals - 1) / intervals);
  } else if (crossed) {
    result.stride = std::clamp(kSamplesAlong / intervals, 1u, kSamplesBetween);
  }
  const std::size_t n = result.stride * intervals;
  for (std::size_t i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    result.at.push_back(i == n ? range.to : range.from + t * (range.to - range.from));
  }
  return result;
}

struct Surface {
  std::unique_ptr<HeightSource> heights;
  std::size_t x_stride = 1, y_stride = 1;
};

Surface surface_of(const SurfaceOptions& options) {
  const bool x_curves = options.lines != CurveFamilies::y, y_curves = options.lines != CurveFamilies::x;
  Surface surface;
  if (!options.grid.empty()) {
    Warnings warnings;
    surface.heights = read_grid(options.grid, warnings);
    for (const auto& [kind, count] : warnings.counts()) {
      if (!options.run.quiet) warn(options.grid, std::to_string(count) + " " + kind);
    }
    surface.x_stride = surface.y_stride = options.every.value_or(1);
  } else {
    Positions x = positions(options.x, y_curves, options.samples), y = positions(options.y, x_curves, options.samples);
    surface.x_stride = x.stride;
    surface.y_stride = y.stride;
    surface.heights = formula_heights(options.formula, std::move(x.at), std::move(y.at));
  }
  if (!x_curves) surface.x_stride = 0;
  if (!y_curves) surface.y_stride = 0;
  return surface;
}

/// The factor by which heights take half of the larger side of the ground.
double z_scale_of(const SurfaceOptions& options, const HeightSource& heights, const HeightSurvey& survey) {
  if (options.z_scale) return *options.z_scale;
  if (survey.empty()) return 1;
  const double height = survey.high - survey.low;
  const double side = std::max(heights.x().back() - heights.x().front(), heights.y().back() - heights.y().front());
  const double scale = side / (2 * height);
  return height > 0 && std::isfinite(scale) ? scale : 1;
}

/// The camera's options, the two angles told as a direction.
ViewOptions view_of(const SurfaceOptions& options) {
  ViewOptions view = options.view;
  view.up_axis = view.up_axis.value_or(Axis::z);
  if (options.view_given) return view;
  const double degree = std::acos(-1.0) / 180;
  const double azimuth = options.azimuth_degrees.value_or(kAzimuth) * degree;
  const double elevation = options.elevation_degrees.value_or(kElevation) * degree;
  view.direction = Point3{-std::cos(azimuth) * std::cos(elevation), -std::sin(azimuth) * std::cos(elevation), -std::sin(elevation)};
  return view;
}

void draw(const SurfaceOptions& options) {
  RunReport run;
  run.method = "horizon";
  const Surface surface = timed(run.stages, "read", [&] { return surface_of(options); });
  const HeightSource& heights = *surface.heights;
  const std::string place_of_warnings = options.grid.empty() ? "surface" : options.grid;

  HorizonOptions horizon;
  Surroundings around;
  const Placement& placement = around.placement;
  timed(run.stages, "place", [&] {
    const HeightSurvey found = survey(heights);
    horizon.holes = found.holes;
    horizon.z_scale = z_scale_of(options, heights, found);
    const Camera camera = camera_of(view_of(options), box_of(heights, found, horizon.z_scale));
    around = place_with_axes(heights, found, horizon.z_scale, camera, options.page, options.axes, options.title);
    horizon.back_lines = back_lines(around);
  });
  horizon.outline = true;
  horizon.x_stride = surface.x_stride;
  horizon.y_stride = surface.y_stride;
  if (options.pixels) horizon.resolution = options.resolution.value_or(kResolution);
  Drawing drawing;
  HorizonLines lines;
  timed(run.stages, "study", [&] {
    ProgressBar bar(options.run);
    if (bar.wanted()) horizon.progress = [&bar](double fraction) { bar.update(fraction); };
    lines = horizon_lines(heights, placement.view, horizon, run.study);
    const auto add = [&](const char* layer, Polylines& polylines) {
      if (polylines.size() > 0) drawing.layers.push_back({layer, std::move(polylines)});
    };
    add("horizon", lines.curves);
    add("outline", lines.outline);
  });
  if (!options.run.quiet) {
    if (drawing.layers.empty()) {
      warn(place_of_warnings, "nothing to draw is in view: the drawing is empty");
    } else if (placement.larger_than_page()) {
      warn(place_of_warnings, "the picture is larger than the page: what lies outside is left out");
    }
  }

  const std::size_t unknown = add_surroundings(drawing, around, options.axes, lines);
  if (unknown > 0 && !options.run.quiet) warn(place_of_warnings, std::to_string(unknown) + " characters are not in the font: drawn as boxes");

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

void setup_surface(CLI::App& app, SurfaceOptions& options) {
  CLI::App* surface = app.add_subcommand("surface", "z = f(x,y): iso-curves, hidden parts removed");
  surface->add_option("EXPR", options.formula, "formula in x and y; also r and theta (polar), pi, e")->type_name("");
  const std::string group = "Surface";
  surface->add_option("--grid", options.grid, "heights from a file instead: CSV or TSV matrix, gnuplot blocks, ESRI ASCII grid, PGM, PNG")
      ->type_name("FILE")
      ->group(group);
  add_parsed(*surface, "-x", "A:B[:N]", options.x, parse_range, "range of x and number of curves of constant x")
      ->default_str("-5:5:40")
      ->group(group);
  add_parsed(*surface, "-y", "A:B[:N]", options.y, parse_range, "range of y and number of curves of constant y")
      ->default_str("-5:5:40")
      ->group(group);
  add_parsed(*surface, "--samples", "N", options.samples, [](const std::string& t) { return parse_count(t, 2, kMostSamples); },
             "points along a curve, or the next more that the crossings with the other family allow")
      ->default_str("5 between curves, up to 1000")
      ->group(group);
  add_parsed(*surface, "--every", "N", options.every, [](const std::string& t) { return parse_count(t, 1, kMostSamples); },
             "grid: a curve at every Nth row and column")
      ->default_str("1")
      ->group(group);
  add_parsed(*surface, "--lines", "x|y|xy", options.lines,
             [](const std::string& t) { return static_cast<CurveFamilies>(parse_choice(t, kCurveFamilyNames)); },
             "curves of constant x, of constant y, or both")
      ->default_str("xy")
      ->group(group);
  add_parsed(*surface, "--z-scale", "K", options.z_scale, parse_positive,
             "heights are multiplied by K (default: they take half of the larger side of the ground)")
      ->group(group);
  add_parsed(*surface, "--horizon", "exact|pixels", options.pixels,
             [](const std::string& t) {
               constexpr std::string_view kNames[] = {"exact", "pixels"};
               return parse_choice(t, kNames) == 1;
             },
             "horizon as polylines in full precision, or as an array of pixels")
      ->default_str("exact")
      ->group(group);
  add_parsed(*surface, "--resolution", "N", options.resolution,
             [](const std::string& t) { return parse_count(t, 1, kHighestResolution); }, "pixels: columns across the picture")
      ->default_str("2000")
      ->group(group);
  add_parsed(*surface, "--azimuth", "DEG", options.azimuth_degrees, parse_number,
             "direction in which the viewer stands, from the x axis towards y")
      ->default_str("-60")
      ->group("View");
  add_parsed(*surface, "--elevation", "DEG", options.elevation_degrees,
             [](const std::string& t) { return parse_within(t, -90, 90, "degrees"); }, "how high the viewer stands over the ground")
      ->default_str("30")
      ->group("View");
  add_view_options(*surface, options.view);
  surface->get_option("--view")->default_str("by azimuth and elevation");
  add_axes_options(*surface, options.axes);
  add_page_options(*surface, options.page);
  add_output_options(*surface, options.output, "svg pdf png (default: by the suffix)");
  add_parsed(*surface, "--dpi", "N", options.dpi,
             [](const std::string& t) { return parse_within(t, kLowestDpi, kHighestDpi, "dots per inch"); }, "resolution of a PNG")
      ->default_str("150")
      ->group("Output");
  surface->add_option("--title", options.title, "title above the picture, and of the document")->type_name("TEXT")->group("Output");
  add_run_options(*surface, options.run);
  surface->callback([surface, &options] {
    for (const char* name : {"--view", "--direction", "--eye"}) options.view_given |= surface->count(name) > 0;
  });
  surface->footer(kExamples);
}

void run_surface(const SurfaceOptions& options) {
  check(options);
  run_with_threads(options.run, [&] { draw(options); });
}

}  // namespace ligne
