#include <stdexcept>
#include <string>

#include "cli/commands.hpp"
#include "cli/options/options.hpp"
#include "files/closest_name.hpp"
#include "files/message_text.hpp"
#include "picture/hatching/hatching.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/parse/parse_terrain.hpp"
#include "picture/surface/surface_request.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Takes an optional number: sets `given`, and `target` if there is a number.
template <class Target>
auto flag_with_number(bool& given, Target& target) {
  return [&given, &target](const std::string& text) {
    given = true;
    if (!text.empty()) target = parse_number(text);
  };
}

/// Options of ligne surface for the lengths of its axes.

void add_surface_scale_options(CLI::App& surface, SurfaceRequest& request) {
  OptionGroup group(surface, "Surface");
  group.add(
      "--aspect", "equal|box|X:Y:Z", request.aspect, parse_aspect,
      "proportions of the plot box. equal: one scale for x and y; box: x and y of equal length; or a ratio (default: equal "
      "if the ranges differ by less than a factor of 4 or the ground has a unit; else box)");
  const Option z_scale =
      group.add("--z-scale", "K", request.z_scale, parse_positive,
                "scale of z relative to the longer of x and y (default: heights take half of its length; parametric: 1)");
  group
      .add("--exaggeration", "K", request.exaggeration, parse_positive,
           "vertical exaggeration; 1 is true to scale, also for positions in degrees")
      .excludes({z_scale});
  group.add_flag("--log-x", request.log_axes[0], "logarithmic x axis");
  group.add_flag("--log-y", request.log_axes[1], "logarithmic y axis");
  group.add_flag("--log-z", request.log_axes[2], "logarithmic z axis: heights are log10 of the formula or the grid");
}

/// Options of ligne surface for lines in addition to the curves, and for their occluder.

constexpr std::string_view kOutlineNames[] = {"off", "on"}, kUndersideNames[] = {"same", "apart", "none"},
                           kHiddenByNames[] = {"surface", "curves"}, kHorizonNames[] = {"exact", "pixels"};

void add_curve_options(CLI::App& app, CurveRequest& request) {
  OptionGroup group(app, "Curves");
  group.add_text(
      "--contours", "N|N:even|Z,...", [&request](const std::string& text) { parse_contours(text, request); },
      "about N contour lines at round heights; N:even: exactly N, equally spaced; Z,...: at these heights (a single one: "
      "Z,)");
  group.add("--contour-step", "DZ", request.contour_step, parse_positive, "contour lines at all multiples of DZ");
  group.add_flag_or_value(
      "--contours-base", "[Z]", flag_with_number(request.contours_base, request.contour_base),
      "contour lines on a plane at height Z (default: lowest height minus 30 % of the range); without --contours: 10 lines, "
      "only there");
  group.add("--outline", "on|off", request.outline, parse_word<bool>(kOutlineNames),
            "silhouettes and borders of the surface, in their own layers (default: on)");
  group.add("--underside", "same|apart|none", request.underside, parse_word<Underside>(kUndersideNames),
            "curves on the underside: with the others, in layer underside, or not drawn", "same");
  group.add("--hidden-by", "surface|curves", request.hidden_by, parse_word<HiddenBy>(kHiddenByNames),
            "what hides: the surface with all its samples, or only the drawn curves, as in the classical method", "surface");
  group.add_flag_or_value("--ridgeline", "[K]", flag_with_number(request.ridgeline, request.ridgeline_overlap),
                          "ridgeline plot, as on the cover of Unknown Pleasures; heights span K rows (default: 6)");
}

constexpr unsigned kMostSamples = 1'000'000, kHighestResolution = 1'000'000, kResolution = 2000,
                   kMostBands = 65535;  // a TIFF has no more

constexpr const char* kSurfaceExamples = R"help(Examples:
  ligne surface "sin(r)/r" -x -12:12:60 -y -12:12:60 -o sombrero.svg
  ligne surface --grid terrain.asc --every 2 --z-scale 2 --azimuth 30 -o terrain.pdf
  ligne surface "sin(x*y)" -x -3:3 -y -3:3 --lines x --eye 8,-6,5 --pen-width 0.2 -o waves.svg
  ligne surface "x^2+y^2" "8-x^2-y^2" --z-range 0:8 --hidden dashed -o bowls.svg
  ligne surface --parametric "(3+cos(v))*cos(u)" "(3+cos(v))*sin(u)" "sin(v)" -o torus.svg)help";

/// Refuses requests that combine features of the horizon only with features of meshes only.
void check_engines(const SurfaceOptions& options, const SurfaceRequest& request) {
  const PictureRequest& picture = request.picture;
  const std::string reason = options.as_mesh ? "--as-mesh" : needs_mesh(request);
  if (options.horizon_given && picture.hatch.is_requested()) refuse_hatching("horizon");
  if (options.horizon_given && !reason.empty()) {
    throw UsageError("--method", "horizon can not draw " + reason + "; a mesh method does: ligne methods");
  }
  const std::string other = needs_horizon(request);
  if (!other.empty() && (picture.lines.method || !reason.empty())) {
    const std::string mesh = reason.empty() ? "--method " + std::string(picture.lines.method->traits().name) : reason;
    throw UsageError(other, "is drawn by method horizon only, and can not be combined with " + mesh);
  }
  if (options.as_mesh) {
    if (request.curves.contours || request.curves.contour_step)
      throw UsageError("--contours", "are lines, which --as-mesh does not write");
    if (picture.hatch.is_requested()) throw UsageError("--hatch", "makes lines, which --as-mesh does not write");
    if (picture.fill.is_requested()) throw UsageError("--fill", "makes areas, which --as-mesh does not write");
    if (picture.axes.style) throw UsageError("--axes", "are lines, which --as-mesh does not write");
    return;
  }
  check(picture);
  if (picture.axes.style && picture.output.format == OutputFormat::json) {
    throw UsageError("--axes", "are not written as json");
  }
}

/// Adds the options for reading files of grids and tables.
void add_grid_options(OptionGroup& group, SurfaceRequest& request) {
  group.add("--gridded", "N", request.gridded, count_between(2, kMostCurves),
            "scattered points: columns of the sampling grid (default: square root of their number, 100 to 500)");
  group.add("--using", "X:Y:Z|Z", request.using_columns, parse_columns,
            "grid, table: columns of x, y and z, or of z alone, by name or by number from 1");
  group.add("--index", "N", request.data_set, count_between(0, kMostDataSets),
            "grid: number of the data set to draw, from 0, in a text with two blank lines between data sets (default: all)");
  group.add(
      "--layout", "matrix|frame|series|columns", request.layout, parse_layout,
      "grid, layout of a table. matrix: only heights; frame: first row and column are positions; series: first column is "
      "positions; columns: x, y and z (default: detected)");
  group.add("--band", "N", request.band, count_between(1, kMostBands), "grid: raster band that has the heights", "1");
  group.add("--ground", "metres|degrees", request.ground, parse_ground,
            "unit of the positions of a grid: that of the heights, or degrees (default: from the file)");
  group.add("--max-slope", "S", request.max_slope, parse_positive, "grid: omit cells with a slope above S");
}

void add_source_options(CLI::App& surface, SurfaceRequest& request) {
  add_arguments(surface, "EXPR", request.formulas, false, "formulas in x and y; also r and theta (polar), pi, e");
  OptionGroup group(surface, "Surface");
  group.add_each(
      "--grid", "FILE", request.grids, std::identity(),
      "heights from a file, - for standard input: CSV or TSV matrix, table, lines of x y z, ESRI ASCII grid, PGM, PNG, "
      "GeoTIFF (repeatable)");
  add_parametric(group, request, "a surface as three formulas in u and v (repeatable)");
  group.add("-x", "A:B[:N]", request.x, parse_range, "range of x and number of curves of constant x; with --grid a window",
            "-5:5:40");
  group.add("-y", "A:B[:N]", request.y, parse_range, "range of y, likewise", "-5:5:40");
  add_parameter_ranges(group, request);
  group.add("--samples", "N", request.samples, count_between(2, kMostSamples),
            "points per curve, rounded up so that crossings with the other family are among them",
            "5 between curves, up to 1000");
  group.add("--every", "N|auto", request.every, parse_every,
            "grid: a curve at every Nth row and column; auto: so that curves are 1.5 pen widths apart", "auto");
  add_grid_options(group, request);
  group.add("--lines", "x|y|xy|none", request.lines, parse_word<CurveFamilies>(kCurveFamilyNames),
            "curves to draw: of constant x, of constant y, both, or none (only contours and outlines)", "xy");
  group.add("--z-range", "A:B", request.z_range, parse_heights, "clip the surface to heights A to B");
  group.add_flag_or_value("--skirt", "[Z]", flag_with_number(request.skirt, request.skirt_base),
                          "walls from the border down to height Z (default: lowest height minus 5 % of the range)");
}

/// Adds --method and --hidden.
void add_method_choice(CLI::App& surface, SurfaceOptions& options) {
  OptionGroup group(surface, "Lines");
  const auto take_method = [&options](const std::string& text) {
    LineRequest& lines = options.request.picture.lines;
    options.horizon_given = text == "horizon";
    lines.method = text == "horizon" || text == "auto" ? nullptr : find_method(text);
    if (text == "horizon" || text == "auto" || lines.method) return;
    std::vector<std::string_view> names{"auto", "horizon"};
    for (const Method* method : all_methods()) names.push_back(method->traits().name);
    throw std::invalid_argument(shown(text, '"') + " is not one of " + list_of(names) + suggestion(text, names));
  };
  group.add_text("--method", "NAME", take_method,
                 "horizon, or a mesh method (see ligne methods); auto: horizon if it can draw the request", "auto");
  group.add("--hidden", "HOW", options.request.picture.lines.hidden, parse_hidden,
            "draw hidden lines in their own layer: none dashed solid", "none");
}

void add_horizon_options(CLI::App& surface, SurfaceOptions& options) {
  OptionGroup group(surface, "Surface");
  group.add("--horizon", "exact|pixels", options.pixels, parse_word<bool>(kHorizonNames),
            "the horizon as exact polylines, or as an array of pixels", "exact");
  group.add("--resolution", "N", options.resolution, count_between(1, kHighestResolution),
            "pixels: columns across the picture", "2000");
}

void add_angle_options(CLI::App& surface, SurfaceRequest& request) {
  OptionGroup group(surface, "View");
  group.add("--azimuth", "DEG", request.azimuth_degrees, parse_number, "azimuth of the viewer, from the x axis towards y",
            "-60");
  group.add(
      "--elevation", "DEG", request.elevation_degrees,
      [](const std::string& t) { return parse_within(t, -90, 90, "degrees"); }, "elevation of the viewer above the ground",
      "30");
}

}  // namespace

MeshFormat mesh_format_of(const OutputOptions& options) {
  if (!options.file) throw UsageError("--output", "there is no output file: -o FILE");
  if (options.format) {
    if (*options.format == OutputFormat::json) return MeshFormat::ligne_scene;
    throw UsageError("--format", "--as-mesh writes json; a file name that ends in .obj gives obj");
  }
  try {
    return mesh_format_of_suffix(*options.file);
  } catch (const std::invalid_argument& e) {
    throw UsageError("--output", e.what());
  }
}

SurfaceRequest checked_request(const SurfaceOptions& options, const MemoryLimit& memory) {
  if (!options.output.file) throw UsageError("--output", "there is no output file: -o FILE, or -o - --format NAME");
  SurfaceRequest request = options.request;
  PictureRequest& picture = request.picture;
  picture.memory = memory;
  check(request);
  if (options.as_mesh) {
    mesh_format_of(options.output);
  } else {
    picture.output.format = format_of(options.output);
  }
  check(picture.page);
  const bool view_given = picture.view.named_view || picture.view.direction || picture.view.eye;
  const bool angles_given = request.azimuth_degrees || request.elevation_degrees;
  if (angles_given && view_given) {
    throw UsageError("--azimuth, --elevation", "can not be combined with --view, --direction or --eye");
  }
  if (options.resolution && !options.pixels) throw UsageError("--resolution", "needs --horizon pixels");
  request.horizon = options.horizon_given;
  if (options.pixels) request.pixel_columns = options.resolution.value_or(kResolution);
  check_axes(picture.axes, options.axes_style);
  if (request.curves.ridgeline && (view_given || angles_given)) throw UsageError("--ridgeline", "sets the view");
  check_engines(options, request);
  return request;
}

void setup_surface(CLI::App& app, SurfaceOptions& options) {
  CLI::App* surface =
      add_command(app, "surface", "Draw surfaces z = f(x,y) as curves with hidden lines removed", kSurfaceExamples);
  SurfaceRequest& request = options.request;
  PictureRequest& picture = request.picture;
  add_source_options(*surface, request);
  add_surface_scale_options(*surface, request);
  add_curve_options(*surface, request.curves);
  add_terrain_options(*surface, request);
  add_annotation_options(*surface, request);
  add_hatch_options(*surface, picture.hatch);
  add_fill_options(*surface, picture.fill);
  add_method_choice(*surface, options);
  add_horizon_options(*surface, options);
  add_angle_options(*surface, request);
  add_view_options(*surface, picture.view, "from --azimuth and --elevation");
  add_axes_options(*surface, picture.axes, options.axes_style);
  add_page_options(*surface, picture.page);
  add_output_options(*surface, options.output, "svg pdf png json hpgl gcode (default: by the suffix)");
  OptionGroup(*surface, "Output")
      .add_flag("--as-mesh", options.as_mesh, "write the surface as a mesh file, .json (ligne-scene) or .obj");
  add_dpi_option(*surface, picture.output.dpi);
  add_curves_option(*surface, picture.output.curves, "off");
  add_title_option(*surface, picture.output.title, "title above the picture, and of the document");
  add_plotter_options(*surface, options.plotter);
  add_run_options(*surface, options.run);
}

}  // namespace ligne
