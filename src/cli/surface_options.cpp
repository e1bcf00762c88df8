#include "cli/surface_options.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "files/message_text.hpp"
#include "scene/surfaces/surface_points.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

constexpr double kLowestDpi = 1, kHighestDpi = 9600;
constexpr unsigned kMostCurves = 20'000, kMostSamples = 1'000'000, kHighestResolution = 1'000'000;
constexpr double kAzimuth = -60, kElevation = 30;

constexpr const char* kExamples = R"help(Examples:
  ligne surface "sin(r)/r" -x -12:12:60 -y -12:12:60 -o sombrero.svg
  ligne surface --grid terrain.asc --every 2 --z-scale 2 --azimuth 30 -o terrain.pdf
  ligne surface "sin(x*y)" -x -3:3 -y -3:3 --lines x --eye 8,-6,5 --pen-width 0.2 -o waves.svg
  ligne surface "x^2+y^2" "8-x^2-y^2" --z-range 0:8 --hidden dashed -o bowls.svg
  ligne surface --parametric "(3+cos(v))*cos(u)" "(3+cos(v))*sin(u)" "sin(v)" -o torus.svg)help";

/// A number, or a formula of numbers such as 2*pi.
double parse_constant(const std::string& text) {
  try {
    const double value = constant_of(text);
    if (std::isfinite(value)) return value;
  } catch (const InputError& e) {
    throw std::invalid_argument(e.what());
  }
  throw std::invalid_argument(shown(text, '"') + " is not a finite number");
}

/// "A:B", and what stands behind the second colon.
struct Ends {
  double from, to;
  std::optional<std::string> rest;
};

Ends parse_ends(const std::string& text, const std::string& form) {
  const std::size_t first = text.find(':');
  if (first == std::string::npos) throw std::invalid_argument(shown(text, '"') + " is not " + form);
  const std::size_t second = text.find(':', first + 1);
  Ends ends{parse_constant(text.substr(0, first)), 0, {}};
  ends.to = parse_constant(text.substr(first + 1, second == std::string::npos ? second : second - first - 1));
  if (second != std::string::npos) ends.rest = text.substr(second + 1);
  if (!(ends.from < ends.to)) throw std::invalid_argument("the range " + printable(text) + " does not ascend");
  if (!std::isfinite(ends.to - ends.from)) throw std::invalid_argument("the range " + printable(text) + " is too large");
  return ends;
}

/// "A:B" or "A:B:N".
CurveRange parse_range(const std::string& text) {
  const Ends ends = parse_ends(text, "A:B or A:B:N");
  CurveRange range{ends.from, ends.to, {}};
  if (ends.rest) range.curves = parse_count(*ends.rest, 2, kMostCurves);
  return range;
}

std::array<double, 2> parse_heights(const std::string& text) {
  const Ends ends = parse_ends(text, "A:B");
  if (ends.rest) throw std::invalid_argument(shown(text, '"') + " is not A:B");
  return {ends.from, ends.to};
}

/// The option that only meshes can serve, or nothing.
std::string needs_mesh(const SurfaceOptions& options) {
  if (!options.parametric.empty()) return "--parametric";
  if (options.formulas.size() + options.grids.size() > 1) return "several surfaces";
  if (options.z_range) return "--z-range";
  if (options.skirt) return "--skirt";
  if (options.hidden != HiddenLines::none) return "--hidden";
  if (options.hatch.asked()) return "--hatch";
  if (options.as_mesh) return "--as-mesh";
  if (format_of(options.output) == OutputFormat::json) return "json";
  return "";
}

void check_sources(const SurfaceOptions& options) {
  const bool formulas = !options.formulas.empty(), grids = !options.grids.empty(), parametric = !options.parametric.empty();
  if (!formulas && !grids && !parametric) {
    throw UsageError("surface: give a formula in x and y, or --grid FILE, or --parametric X Y Z");
  }
  if (!formulas && !grids) {
    if (options.x || options.y) throw UsageError("-x, -y", "go with z = f(x, y); a parametric surface has -u and -v");
    if (options.log_z) throw UsageError("--log-z", "goes with z = f(x, y)");
  }
  if (parametric && options.skirt)
    throw UsageError("--skirt", "goes with z = f(x, y), which has a rim, not with --parametric");
  if (std::max(options.u.size(), options.v.size()) > options.parametric.size()) {
    throw UsageError("-u, -v", parametric ? "there are more of them than parametric surfaces" : "go with --parametric");
  }
  if (!formulas && !parametric && options.samples) throw UsageError("--samples", "a grid has its own samples");
  if (!formulas && ((options.x && options.x->curves) || (options.y && options.y->curves))) {
    throw UsageError("-x, -y", "a grid takes A:B, a window; --every N says which curves are drawn");
  }
  if (!grids && options.every)
    throw UsageError("--every", "goes with --grid; a formula has its number of curves in -x A:B:N");
  if (!grids) return;
}

void add_parameter_range(CLI::App& app, const std::string& name, std::vector<CurveRange>& ranges, const std::string& help) {
  app.add_option_function<std::vector<std::string>>(
         name,
         [&ranges, name](const std::vector<std::string>& texts) {
           try {
             for (const std::string& text : texts) ranges.push_back(parse_range(text));
           } catch (const std::invalid_argument& e) {
             throw UsageError(name, e.what());
           }
         },
         help)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false)
      ->type_name("A:B[:N]")
      ->default_str("0:2*pi:40")
      ->group("Surface");
}

/// --method and --hidden.
void add_method_choice(CLI::App& app, SurfaceOptions& options) {
  app.add_option_function<std::string>(
         "--method",
         [&options](const std::string& text) {
           options.horizon_given = text == "horizon";
           options.method = text == "horizon" || text == "auto" ? nullptr : find_method(text);
           if (text == "horizon" || text == "auto" || options.method) return;
           std::vector<std::string_view> names{"auto", "horizon"};
           for (const Method* method : all_methods()) names.push_back(method->traits().name);
           throw UsageError("--method", shown(text, '"') + " is not one of " + list_of(names));
         },
         "horizon, or a mesh method, see: ligne methods; auto: horizon where it can")
      ->type_name("NAME")
      ->default_str("auto")
      ->group("Lines");
  add_parsed(
      app, "--hidden", "HOW", options.hidden,
      [](const std::string& text) { return static_cast<HiddenLines>(parse_choice(text, kHiddenLinesNames)); },
      "hidden lines in a layer of their own: none dashed solid")
      ->default_str("none")
      ->group("Lines");
}

}  // namespace

const Method& mesh_method_of(const SurfaceOptions& options) {
  if (!options.method && options.hatch.asked()) return region_method();
  MethodOptions choice;
  choice.method = options.method;
  return method_of(choice);
}

bool drawn_by_horizon(const SurfaceOptions& options) { return !options.method && needs_mesh(options).empty(); }

MeshFormat mesh_format_of(const OutputOptions& options) {
  if (!options.file) throw UsageError("--output", "there is no output file: -o FILE");
  if (options.format) {
    if (*options.format == OutputFormat::json) return MeshFormat::ligne_scene;
    throw UsageError("--format", "--as-mesh writes json, or obj by the suffix");
  }
  std::string suffix = std::filesystem::path(*options.file).extension().string();
  for (char& c : suffix) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (suffix == ".json") return MeshFormat::ligne_scene;
  if (suffix == ".obj") return MeshFormat::obj;
  throw UsageError("--output",
                   printable(*options.file, kLongestPath) + " does not end in .json or .obj, which --as-mesh writes");
}

std::string place_of_warnings(const SurfaceOptions& options) {
  return options.grids.size() == 1 && options.formulas.empty() && options.parametric.empty() ? options.grids.front()
                                                                                             : "surface";
}

ViewOptions view_of(const SurfaceOptions& options) {
  ViewOptions view = options.view;
  view.up_axis = view.up_axis.value_or(Axis::z);
  if (options.view_given) return view;
  const double degree = std::acos(-1.0) / 180;
  const double azimuth = options.azimuth_degrees.value_or(kAzimuth) * degree;
  const double elevation = options.elevation_degrees.value_or(kElevation) * degree;
  view.direction =
      Point3{-std::cos(azimuth) * std::cos(elevation), -std::sin(azimuth) * std::cos(elevation), -std::sin(elevation)};
  // Straight from above and below the azimuth says which way is up on the page.
  const double side = std::sin(elevation);
  if (!view.up && std::abs(side) == 1) view.up = Point3{-std::cos(azimuth) * side, -std::sin(azimuth) * side, 0};
  return view;
}

namespace {

/// What only the horizon draws does not go together with what only meshes can.
void check_engines(const SurfaceOptions& options) {
  std::string reason = needs_mesh(options);
  if (options.horizon_given && options.hatch.asked()) refuse_hatching("horizon");
  if (options.horizon_given && !reason.empty())
    throw UsageError("--method", "horizon draws no " + reason + "; a mesh method does: ligne methods");
  const std::string other = options.pixels ? "--horizon pixels" : needs_horizon(options.curves);
  if (!other.empty() && !drawn_by_horizon(options)) {
    if (reason.empty()) reason = "--method " + std::string(options.method->traits().name);
    throw UsageError(other, "is drawn by the method horizon alone, and does not go with " + reason);
  }
  if (options.as_mesh && (options.curves.contours || options.curves.contour_step))
    throw UsageError("--contours", "are lines, which --as-mesh does not write");
  if (options.as_mesh && options.hatch.asked()) throw UsageError("--hatch", "makes lines, which --as-mesh does not write");
  if (!options.as_mesh) check(options.hatch, format_of(options.output), mesh_method_of(options));
  if (options.as_mesh && !options.axes.style.empty())
    throw UsageError("--axes", "are lines, which --as-mesh does not write");
  if (!options.as_mesh && !options.axes.style.empty() && format_of(options.output) == OutputFormat::json) {
    throw UsageError("--axes", "are not written as json");
  }
}

}  // namespace

void check(const SurfaceOptions& options) {
  if (!options.output.file) throw UsageError("--output", "there is no output file: -o FILE, or -o - --format NAME");
  check_sources(options);
  if (options.as_mesh) {
    mesh_format_of(options.output);
  } else {
    format_of(options.output);
  }
  check(options.page);
  if ((options.azimuth_degrees || options.elevation_degrees) && options.view_given) {
    throw UsageError("--azimuth, --elevation", "do not go with --view, --direction or --eye");
  }
  if (options.resolution && !options.pixels) throw UsageError("--resolution", "goes with --horizon pixels");
  check(options.curves);
  if (options.lines == CurveFamilies::none && options.curves.hidden_by == HiddenBy::curves)
    throw UsageError("--hidden-by", "curves needs --lines that hide");
  check(options.axes);
  if (options.curves.ridgeline && (options.view_given || options.azimuth_degrees || options.elevation_degrees)) {
    throw UsageError("--ridgeline", "has its own view");
  }
  check_engines(options);
}

CLI::App* add_surface_command(CLI::App& app, SurfaceOptions& options) {
  CLI::App* surface = app.add_subcommand("surface", "z = f(x,y): iso-curves, hidden parts removed");
  surface->add_option("EXPR", options.formulas, "formulas in x and y; also r and theta (polar), pi, e")->type_name("");
  const std::string group = "Surface";
  surface
      ->add_option("--grid", options.grids,
                   "heights from a file: CSV or TSV matrix, gnuplot blocks, ESRI ASCII grid, PGM, PNG (repeatable)")
      ->type_name("FILE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false)
      ->group(group);
  surface
      ->add_option_function<std::vector<std::string>>(
          "--parametric",
          [&options](const std::vector<std::string>& values) {
            for (std::size_t i = 0; i + 2 < values.size(); i += 3)
              options.parametric.push_back({values[i], values[i + 1], values[i + 2]});
          },
          "a surface as three formulas in u and v (repeatable)")
      ->type_size(3)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false)
      ->type_name("X Y Z")
      ->group(group);
  add_parsed(*surface, "-x", "A:B[:N]", options.x, parse_range,
             "range of x and number of curves of constant x; with --grid a window")
      ->default_str("-5:5:40")
      ->group(group);
  add_parsed(*surface, "-y", "A:B[:N]", options.y, parse_range, "the same of y")->default_str("-5:5:40")->group(group);
  add_parameter_range(*surface, "-u", options.u, "the same of u, of a parametric surface (repeatable: of the next one)");
  add_parameter_range(*surface, "-v", options.v, "the same of v");
  add_parsed(
      *surface, "--samples", "N", options.samples, [](const std::string& t) { return parse_count(t, 2, kMostSamples); },
      "points along a curve, or the next more that the crossings with the other family allow")
      ->default_str("5 between curves, up to 1000")
      ->group(group);
  add_parsed(
      *surface, "--every", "N", options.every, [](const std::string& t) { return parse_count(t, 1, kMostSamples); },
      "grid: a curve at every Nth row and column")
      ->default_str("1")
      ->group(group);
  add_parsed(
      *surface, "--lines", "x|y|xy|none", options.lines,
      [](const std::string& t) { return static_cast<CurveFamilies>(parse_choice(t, kCurveFamilyNames)); },
      "curves of constant x, of constant y, both, or none: contours and outlines alone")
      ->default_str("xy")
      ->group(group);
  add_parsed(*surface, "--z-scale", "K", options.z_scale, parse_positive,
             "heights are multiplied by K (default: they take half of the larger side of the ground; parametric: 1)")
      ->group(group);
  surface->add_flag("--log-z", options.log_z, "heights are log10 of the formula or of the grid")->group(group);
  add_parsed(*surface, "--z-range", "A:B", options.z_range, parse_heights, "cut the surface off below A and above B")
      ->group(group);
  surface
      ->add_option_function<std::vector<std::string>>(
          "--skirt",
          [&options](const std::vector<std::string>& values) {
            options.skirt = true;
            try {
              if (!values.empty() && !values[0].empty()) options.skirt_base = parse_number(values[0]);
            } catch (const std::invalid_argument& e) {
              throw UsageError("--skirt", e.what());
            }
          },
          "walls from the rim down to the height Z (default: 5 % of the range of heights below the lowest)")
      ->expected(0, 1)
      ->type_name("[Z]")
      ->group(group);
  add_curve_options(*surface, options.curves);
  add_hatch_options(*surface, options.hatch);
  add_method_choice(*surface, options);
  add_parsed(
      *surface, "--horizon", "exact|pixels", options.pixels,
      [](const std::string& t) {
        constexpr std::string_view kNames[] = {"exact", "pixels"};
        return parse_choice(t, kNames) == 1;
      },
      "horizon as polylines in full precision, or as an array of pixels")
      ->default_str("exact")
      ->group(group);
  add_parsed(
      *surface, "--resolution", "N", options.resolution,
      [](const std::string& t) { return parse_count(t, 1, kHighestResolution); }, "pixels: columns across the picture")
      ->default_str("2000")
      ->group(group);
  add_parsed(*surface, "--azimuth", "DEG", options.azimuth_degrees, parse_number,
             "direction in which the viewer stands, from the x axis towards y")
      ->default_str("-60")
      ->group("View");
  add_parsed(
      *surface, "--elevation", "DEG", options.elevation_degrees,
      [](const std::string& t) { return parse_within(t, -90, 90, "degrees"); }, "how high the viewer stands over the ground")
      ->default_str("30")
      ->group("View");
  add_view_options(*surface, options.view);
  surface->get_option("--view")->default_str("by azimuth and elevation");
  add_axes_options(*surface, options.axes);
  add_page_options(*surface, options.page);
  add_output_options(*surface, options.output, "svg pdf png json hpgl gcode (default: by the suffix)");
  surface->add_flag("--as-mesh", options.as_mesh, "write the surface as a mesh file, .json (ligne-scene) or .obj")
      ->group("Output");
  add_parsed(
      *surface, "--dpi", "N", options.dpi,
      [](const std::string& t) { return parse_within(t, kLowestDpi, kHighestDpi, "dots per inch"); }, "resolution of a PNG")
      ->default_str("150")
      ->group("Output");
  surface->add_option("--title", options.title, "title above the picture, and of the document")
      ->type_name("TEXT")
      ->group("Output");
  add_plotter_options(*surface, options.plotter);
  add_run_options(*surface, options.run);
  surface->callback([surface, &options] {
    for (const char* name : {"--view", "--direction", "--eye"}) options.view_given |= surface->count(name) > 0;
  });
  surface->footer(kExamples);
  return surface;
}

}  // namespace ligne
