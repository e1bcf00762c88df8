#include "cli/draw.hpp"

#include <utility>

#include "cli/fill_options.hpp"
#include "cli/hatch_options.hpp"
#include "cli/mixed_scene_options.hpp"
#include "cli/options.hpp"
#include "cli/page_options.hpp"
#include "cli/progress.hpp"
#include "cli/view_options.hpp"
#include "picture/clear_creases.hpp"
#include "picture/compiled_model.hpp"
#include "picture/draw_scene.hpp"
#include "picture/frame_names.hpp"
#include "picture/frames.hpp"
#include "picture/parse.hpp"
#include "picture/parse_options.hpp"

namespace ligne {
namespace {

constexpr const char* kDrawExamples = R"(Examples:
  ligne draw gearbox.obj -o gearbox.svg
  ligne draw flange.glb --view front --scale 1:2 --unit m --hidden dashed --page A3 -o flange.pdf
  ligne draw houses.json --grid terrain.asc --every 4 --view iso -o village.svg
  ligne draw tower.obj --eye 9,6,14 --fov 40 -q -o - --format svg | rsvg-convert -z 2 > tower.png)";

void add_profile_option(CLI::App& app, std::optional<ProfileKind>& profile) {
  OptionGroup(app, "Lines")
      .add("--profile", "HOW", profile, parse_profile,
           "outer outlines wide, in a layer of their own: sheet, where the sheet is behind; parts, another object too; off")
      .standard("off; sheet where --edges names profile");
}

void add_frame_options(CLI::App& app, DrawOptions& options) {
  constexpr unsigned kMostFrames = 100'000;
  constexpr double kMostDegrees = 36'000;
  OptionGroup group(app, "View");
  const Option frames = group
                            .add(
                                "--frames", "N", options.frames.count,
                                [](const std::string& text) { return parse_count(text, 2, kMostFrames); },
                                "successive views of the turning model: files -o name%03d.svg, or the pages of one PDF")
                            .standard("one view");
  group
      .add(
          "--turn", "DEG", options.frames.turn_degrees,
          [](const std::string& text) { return parse_within(text, -kMostDegrees, kMostDegrees, "degrees"); },
          "angle by which they turn the model in all, counter-clockwise as seen from above")
      .standard("360")
      .needs(frames);
}

/// The request that the options come to. A wrong one is refused before anything is read.
PictureRequest request_of(const DrawOptions& options, const MemoryLimit& memory) {
  PictureRequest request = options.picture;
  request.memory = memory;
  request.output.format = format_of(options.output);
  if (const std::string* file = compiled_file(options.model); file && !request.lines.method) {
    request.lines.method = method_of_compiled(*file);
  }
  if (!options.method.edges_given && !request.fill.lights.empty()) request.lines.classes.add(LineClass::shadow);
  if (request.lines.profiles() != ProfileKind::off) request.lines.classes.add(LineClass::profile);
  check(request);
  if (options.frames.count > 1) {
    if (!options.plotter.preview.empty()) throw UsageError("--preview", "is of one view");
    if (options.plotter.choice.request.report) throw UsageError("--report", "is of one view");
  }
  check_mixed_scene(options.surfaces);
  request.lines.settings = settings_of(options.method, method_of(request));
  return request;
}

void draw(const DrawOptions& options, PictureRequest request) {
  const bool as_pages = request.output.format == OutputFormat::pdf && !has_number_place(*options.output.file);
  const std::vector<std::string> outputs = numbered_names(*options.output.file, as_pages ? 1 : options.frames.count);
  RunFiles files;
  for (const std::string& name : outputs) files.will_write("--output", name);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--stats-json", options.run.stats_json);
  RunReport run;
  request.plotter = plotter_request(options.plotter.choice, request.output.format, run.files);
  files.were_read(run.files);
  ModelRequest model = options.model;
  model.quality = request.lines.quality;
  model.shading = asks_for_creases(request.lines.studied());
  model.unit_mm = request.page.unit_mm;
  model.tell_parts =
      request.output.group_objects || !request.output.colors.empty() || !request.plotter.pens.pen_of_object.empty();
  LoadedModels models =
      timed(run.stages, reading_of(options.model), [&] { return load_models(model, options.run.quiet, files); });
  add_surfaces(options.surfaces, models, request, run);
  files.were_read(run.files);
  require_parts(models, request);
  request.plotter.fit_drawing = !request.page.scale;
  report_healing(models, model, run);
  if (models.compiled_for && models.compiled_for == request.lines.method) {
    require_no_parameters(models, names_of(options.method));
    request.compiled = models.compiled;
  }
  ProgressBar bar(options.run);
  request.progress = bar.callback();
  const std::string& place = options.model.files.front();
  if (options.frames.count == 1) {
    Picture picture = draw_scene(models.scene, request, run, {}, std::move(models.topology));
    deliver(std::move(picture), outputs.front(), options.plotter.preview, place, options.run, run, files);
    return;
  }
  std::size_t frame = 0;
  draw_frames(models.scene, request, options.frames, as_pages, run, std::move(models.topology),
              [&](Picture picture) { files.write(outputs[frame++], std::move(picture.bytes)); });
  report_warnings(run, place, options.run);
  finish(options.run, run, files);
}

}  // namespace

void setup_draw(CLI::App& app, DrawOptions& options) {
  CLI::App& draw = *add_command(app, "draw", "Hidden-line drawing of meshes and polygon scenes", kDrawExamples);
  PictureRequest& picture = options.picture;
  add_model_options(draw, options.model);
  add_part_drawing_options(draw, picture.output);
  add_profile_option(draw, picture.lines.profile);
  add_view_options(draw, picture.view);
  add_frame_options(draw, options);
  add_line_options(draw, picture.lines, options.method);
  add_fill_options(draw, picture.fill);
  add_mixed_scene_options(draw, options.surfaces);
  add_page_options(draw, picture.page);
  add_output_options(draw, options.output);
  add_dpi_option(draw, picture.output.dpi);
  add_svg_option(draw, picture.output.svg);
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
