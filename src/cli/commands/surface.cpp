#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/options/options.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/parse/parse_terrain.hpp"
#include "picture/surface/surface_picture.hpp"
#include "scene/surfaces/formula/formula_evaluator.hpp"

namespace ligne {
namespace {

void run(const SurfaceOptions& options, SurfaceRequest request) {
  RunFiles files;
  files.will_write("--output", *options.output.file);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--stats-json", options.run.stats_json);
  RunReport report;
  Picture picture;
  if (options.as_mesh) {
    picture.bytes = write_surface_mesh(request, mesh_format_of(options.output), report);
  } else {
    request.picture.plotter = plotter_request(options.plotter.choice, request.picture.output.format, report.files);
    request.picture.plotter.fit_drawing = !request.picture.page.scale;
    files.were_read(report.files);
    ProgressBar bar(options.run);
    request.picture.progress = bar.callback();
    picture = draw_surface(request, report);
    if (!options.run.quiet) {
      warn_of_suffix(options.output);
      const PictureRequest& made = request.picture;
      warn_of_idle_options({"surface", options.run.given, made.output.format, made.plotter.by_pens()});
    }
  }
  const std::string preview = options.as_mesh ? "" : options.plotter.preview;
  deliver(std::move(picture), {*options.output.file, preview, place_of_warnings(request)}, options.run, report, files);
}

bool is_formula(const std::string& text, FormulaLanguage language) {
  try {
    const FormulaEvaluator evaluator(prepare_formula(text, std::move(language)));
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

void add_terrain_options(CLI::App& surface, SurfaceRequest& request) {
  CurveRequest& curves = request.curves;
  TerrainRequest& terrain = request.terrain;
  AxesChoice& axes = request.picture.axes;
  OptionGroup group(surface, "Terrain");
  group.add_flag_or_value(
      "--contour-labels", "[index|all]", [&curves](const std::string& text) { curves.labels = parse_contour_labels(text); },
      "label contour lines with their heights: index contours only, or all");
  group.add("--index-contours", "N", curves.index_contours, parse_index_contours,
            "draw every Nth contour line wider, in layer contour-index; 0: none", "5 with --contour-step, else 0");
  group.add_text(
      "--water", "Z|nodata", [&terrain](const std::string& text) { parse_water(text, terrain); },
      "treat areas below Z as water, or areas of a grid without heights; the shoreline is layer shore");
  group.add("--water-fill", "blank|hatch", terrain.water_fill, parse_water_fill,
            "leave water blank, or hatch it with horizontal strokes in layer water", "blank");
  group.add("--hachures", "none|contour|slope", terrain.hachures, parse_hachures,
            "hill shading by hachures along contour lines or down the slope, in layer hatch", "none");
  group.add("--hachure-spacing", "LEN", terrain.hachure_mm, parse_hatch_spacing,
            "distance between strokes in the darkest tone", "2.2 pen widths");
  group.add_text(
      "--sun", "AZIMUTH[:ALTITUDE]", [&terrain](const std::string& text) { parse_sun(text, terrain); },
      "direction of the light for hachures: degrees clockwise from north (y), and degrees above the ground", "315:45");
  group.add_flag_or_value(
      "--scale-bar", "[UNIT]",
      [&axes](const std::string& text) {
        axes.scale_bar = true;
        axes.scale_unit = text;
      },
      "a scale bar below the picture, in UNIT (default: metres if the ground is in metres, else units of x)");
  group.add_flag("--north-arrow", axes.north_arrow, "an arrow that points north, the direction of y");
}

void add_annotation_options(CLI::App& surface, SurfaceRequest& request) {
  OptionGroup group(surface, "Annotation");
  group.add_repeatable_tuple(
      "--curve", "X Y Z", 3,
      [&request](const std::vector<std::string>& xyz) {
        request.space_curves.push_back({xyz[0], xyz[1], xyz[2]});
      },
      "a space curve given by three formulas in t; surfaces can hide it; Z may be the word surface: on the surface "
      "(repeatable)");
  group.add_each("-t", "A:B[:N]", request.t, parse_range,
                 "range of t and number of segments (repeatable: for the next curve)", "0:2*pi:600");
  group.add_each(
      "--points", "FILE", request.point_files, std::identity(),
      "markers at the visible points of a table or of arrays: x, y, optional z (default: on the surface), optional label "
      "(repeatable)");
  group.add_each("--path", "FILE", request.line_files, std::identity(),
                 "polylines through the points of a table, separated by blank lines (repeatable)");
  group.add("--colors", "COLOUR,...", request.colors, parse_colors,
            "colours of the surfaces in their order, or of the bands");
  group.add("--bands", "N|Z,...", request.bands, parse_bands,
            "colours by height: N bands of equal height, or bands between the heights Z");
  group.add_flag("--legend", request.legend, "a legend of the surfaces, curves or bands below the picture");
  group.add_each("--name", "TEXT", request.names, std::identity(), "text of the next legend entry (repeatable)");
  for (int k = 0; k < 3; ++k) {
    const std::string axis(1, "xyz"[k]);
    auto& names = request.picture.axes.categories[static_cast<std::size_t>(k)];
    group.add_text(
        "--" + axis + "-names", "TEXT,...", [&names](const std::string& text) { names = parse_words(text); },
        "names in place of the numbers 0, 1, 2, ... on the " + axis + " axis");
  }
}

void protect_formulas(std::vector<std::string>& arguments, const std::function<bool(const std::string&)>& awaits_value) {
  constexpr std::array<std::string_view, 2> kParameters{"u", "v"};
  constexpr std::array<std::string_view, 1> kCurveParameter{"t"};
  std::size_t parametric = 0;  // formulas of --parametric or --curve still expected
  bool curve = false;
  for (std::size_t k = 1; k < arguments.size(); ++k) {
    std::string& argument = arguments[k];
    const bool is_parametric = parametric > 0;
    const FormulaLanguage language = !is_parametric ? FormulaLanguage{kFormulaVariables}
                                     : curve        ? FormulaLanguage{kCurveParameter}
                                                    : FormulaLanguage{kParameters};
    const bool is_value = parametric == 0 && awaits_value(arguments[k - 1]);
    if (!is_parametric) curve = argument == "--curve";
    parametric = argument == "--parametric" || argument == "--curve" ? 3 : parametric > 0 ? parametric - 1 : 0;
    const bool begins_with_minus = argument.size() > 1 && argument[0] == '-' && argument[1] != '-';
    const bool is_option =
        !is_parametric && (argument == "-x" || argument == "-y" || argument == "-u" || argument == "-v" || argument == "-t");
    if (!begins_with_minus || is_value || is_option) continue;
    if (is_formula(argument, language)) argument = "(" + argument + ")";
  }
}

void run_surface(const SurfaceOptions& options) {
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { run(options, checked_request(options, memory)); });
}

}  // namespace ligne
