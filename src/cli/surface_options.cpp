#include "cli/surface_options.hpp"

#include <cmath>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"

namespace ligne {
namespace {

constexpr double kLowestDpi = 1, kHighestDpi = 9600;
constexpr unsigned kMostCurves = 20'000, kMostSamples = 1'000'000, kHighestResolution = 1'000'000;

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

}  // namespace

void check(const SurfaceOptions& options) {
  if (options.formula.empty() == options.grid.empty()) {
    throw UsageError("surface: give a formula in x and y, or --grid FILE" + std::string(options.grid.empty() ? "" : ", not both"));
  }
  const OutputFormat format = format_of(options.output);
  if (format == OutputFormat::json) throw UsageError("--format", "a surface is written as svg, pdf or png");
  check(options.page);
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

CLI::App* add_surface_command(CLI::App& app, SurfaceOptions& options) {
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
  add_page_options(*surface, options.page);
  add_output_options(*surface, options.output, "svg pdf png (default: by the suffix)");
  add_parsed(*surface, "--dpi", "N", options.dpi,
             [](const std::string& t) { return parse_within(t, kLowestDpi, kHighestDpi, "dots per inch"); }, "resolution of a PNG")
      ->default_str("150")
      ->group("Output");
  surface->add_option("--title", options.title, "title of an SVG or PDF document")->type_name("TEXT")->group("Output");
  add_run_options(*surface, options.run);
  surface->callback([surface, &options] {
    for (const char* name : {"--view", "--direction", "--eye"}) options.view_given |= surface->count(name) > 0;
  });
  surface->footer(kExamples);
  return surface;
}

}  // namespace ligne
