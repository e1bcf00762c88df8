#include "cli/draw.hpp"

#include <utility>

#include "cli/fill_options.hpp"
#include "cli/hatch_options.hpp"
#include "cli/options.hpp"
#include "cli/page_options.hpp"
#include "cli/parse.hpp"
#include "cli/progress.hpp"
#include "cli/view_options.hpp"
#include "picture/draw_scene.hpp"

namespace ligne {
namespace {

constexpr const char* kExamples = R"(Examples:
  ligne draw gearbox.obj -o gearbox.svg
  ligne draw flange.glb --view front --scale 1:2 --unit m --hidden dashed --page A3 -o flange.pdf
  ligne draw tower.obj --eye 9,6,14 --fov 40 -q -o - --format svg | rsvg-convert -z 2 > tower.png)";

std::vector<std::string> object_patterns(const PenTable& pens) {
  std::vector<std::string> patterns;
  for (const auto& [pattern, number] : pens.pen_of_object) patterns.push_back(pattern);
  return patterns;
}

void add_profile_option(CLI::App& app, std::optional<ProfileKind>& profile) {
  OptionGroup(app, "Lines")
      .add(
          "--profile", "HOW", profile,
          [](const std::string& text) { return static_cast<ProfileKind>(parse_choice(text, kProfileNames)); },
          "outer outlines wide, in a layer of their own: sheet, where the sheet is behind; parts, another object too; off")
      .standard("off; sheet where --edges names profile");
}

/// The request that the options come to. A wrong one is refused before anything is read.
PictureRequest request_of(const DrawOptions& options, const MemoryLimit& memory) {
  PictureRequest request = options.picture;
  request.memory = memory;
  request.output.format = format_of(options.output);
  if (!options.method.edges_given && !request.fill.lights.empty()) request.lines.classes.add(LineClass::shadow);
  if (request.lines.profiles() != ProfileKind::off) request.lines.classes.add(LineClass::profile);
  check(request);
  request.lines.settings = settings_of(options.method, method_of(request));
  return request;
}

void draw(const DrawOptions& options, PictureRequest request) {
  RunFiles files;
  files.will_write("--output", *options.output.file);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--stats-json", options.run.stats_json);
  RunReport run;
  request.plotter = plotter_request(options.plotter.choice, request.output.format, run.files);
  files.were_read(run.files);
  ModelRequest model = options.model;
  model.quality = request.lines.quality;
  model.unit_mm = request.page.unit_mm;
  model.tell_parts =
      request.output.group_objects || !request.output.colors.empty() || !request.plotter.pens.pen_of_object.empty();
  LoadedModels models =
      timed(run.stages, reading_of(options.model), [&] { return load_models(model, options.run.quiet, files); });
  for (const ObjectColor& color : request.output.colors) require_names(models, "color", {color.pattern});
  require_names(models, "pen", object_patterns(request.plotter.pens));
  report_healing(models, model, run);
  ProgressBar bar(options.run);
  request.progress = bar.callback();
  Picture picture = draw_scene(models.scene, request, run, {}, std::move(models.topology));
  deliver(std::move(picture), *options.output.file, options.plotter.preview, options.model.files.front(), options.run, run,
          files);
}

}  // namespace

void setup_draw(CLI::App& app, DrawOptions& options) {
  CLI::App& draw = *add_command(app, "draw", "Hidden-line drawing of meshes and polygon scenes", kExamples);
  PictureRequest& picture = options.picture;
  add_model_options(draw, options.model);
  add_part_drawing_options(draw, picture.output);
  add_profile_option(draw, picture.lines.profile);
  add_view_options(draw, picture.view);
  add_line_options(draw, picture.lines, options.method);
  add_fill_options(draw, picture.fill);
  add_page_options(draw, picture.page);
  add_output_options(draw, options.output);
  add_dpi_option(draw, picture.output.dpi);
  add_curves_option(draw, picture.output.curves, "on; off with --quality exact");
  add_title_option(draw, picture.output.title, "title of an SVG or PDF");
  OptionGroup(draw, "Faces")
      .add_flag("--shade", picture.gray_faces, "PNG: faces in gray, lit from the eye (methods with spans or pixels)");
  add_hatch_options(draw, picture.hatch);
  add_plotter_options(draw, options.plotter);
  add_run_options(draw, options.run);
}

void run_draw(const DrawOptions& options) {
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { draw(options, request_of(options, memory)); });
}

}  // namespace ligne
