#include "cli/draw.hpp"

#include "cli/option_helpers.hpp"
#include "cli/scene_drawing.hpp"

namespace ligne {
namespace {

constexpr double kLowestDpi = 1, kHighestDpi = 9600;

constexpr const char* kExamples = R"(Examples:
  ligne draw gearbox.obj -o gearbox.svg
  ligne draw flange.glb --view front --scale 1:2 --unit m --hidden dashed --page A3 -o flange.pdf
  ligne draw tower.obj --eye 9,6,14 --fov 40 -q -o - --format svg | rsvg-convert -z 2 > tower.png)";

/// The method that is asked for; else, for fills and hatching, one that gives regions.
const Method& method_of(const DrawOptions& options) {
  const bool regions = options.fill.asked() || options.hatch.asked() || options.method.edges.has(LineClass::shadow);
  return regions && !options.method.method ? region_method() : method_of(options.method);
}

void check(const DrawOptions& options) {
  const Method& method = method_of(options);
  check(options.faces, format_of(options.output), method);
  check(options.hatch, format_of(options.output), method);
  if (options.faces.shade && options.hatch.asked()) throw UsageError("--hatch", "does not go together with --shade");
  check(options.page);
}

void draw(const DrawOptions& options) {
  RunFiles files;
  files.will_write("--output", *options.output.file);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--stats-json", options.run.stats_json);
  LineClasses classes = options.method.edges;
  if (!options.method.edges_given && !options.fill.lights.empty()) classes.add(LineClass::shadow);
  const Method& method = method_of(options);
  const MethodSettings settings = settings_of(options.method, method);  // a wrong one is told before anything is read
  const PlotterSetup plotter = plotter_setup(options.plotter, format_of(options.output), files);
  RunReport run;
  const LoadedModels models =
      timed(run.stages, "read", [&] { return load_models(options.model, options.run.quiet, files); });
  draw_scene(models.scene,
             {method, settings, classes, options.method.crease_degrees, options.method.hidden, options.method.cull,
              options.view, options.page, options.output, options.run, options.dpi, options.title,
              options.model.files.front(), nullptr, options.faces, plotter, options.fill, options.hatch},
             files, run);
}

}  // namespace

void setup_draw(CLI::App& app, DrawOptions& options) {
  CLI::App* draw = app.add_subcommand("draw", "Hidden-line drawing of meshes and polygon scenes");
  add_model_options(*draw, options.model);
  add_view_options(*draw, options.view);
  add_method_options(*draw, options.method);
  add_fill_options(*draw, options.fill);
  add_page_options(*draw, options.page);
  add_output_options(*draw, options.output);
  add_parsed(
      *draw, "--dpi", "N", options.dpi,
      [](const std::string& text) { return parse_within(text, kLowestDpi, kHighestDpi, "dots per inch"); },
      "resolution of a PNG")
      ->default_str("150")
      ->group("Output");
  draw->add_option("--title", options.title, "title of an SVG or PDF")->type_name("TEXT")->group("Output");
  add_face_options(*draw, options.faces);
  add_hatch_options(*draw, options.hatch);
  add_plotter_options(*draw, options.plotter);
  add_run_options(*draw, options.run);
  draw->footer(kExamples);
}

void run_draw(const DrawOptions& options) {
  check(options);
  run_with_threads(options.run, [&] { draw(options); });
}

}  // namespace ligne
