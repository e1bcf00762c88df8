#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/options.hpp"
#include "files/message_text.hpp"
#include "files/named_input.hpp"
#include "picture/clear/clear_creases.hpp"
#include "picture/draw_scene.hpp"
#include "picture/errors.hpp"
#include "picture/models/compiled_model.hpp"
#include "picture/pages/frames.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/parts.hpp"
#include "picture/products.hpp"
#include "picture/raster/zbuffer_picture.hpp"
#include "picture/requests.hpp"
#include "picture/surface/mixed_scene.hpp"
#include "scene/surfaces/grids/point_table.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Surfaces z = f(x, y) among the models of ligne draw.

constexpr unsigned kMostSamplesOfCurve = 2000;

void add_mixed_scene_options(CLI::App& draw, SurfaceRequest& request) {
  OptionGroup group(draw, "Surfaces");
  group.add_each("--surface", "EXPR", request.formulas, std::identity(),
                 "draw a surface z = f(x, y) among the models, as curves (repeatable)");
  group.add_each("--grid", "FILE", request.grids, std::identity(),
                 "draw a surface with heights from a file; see ligne surface (repeatable)");
  add_parametric(group, request, "draw a surface given by three formulas in u and v (repeatable)");
  group.add("-x", "A:B[:N]", request.x, parse_range, "range of x and number of curves (default: the extent of the models)");
  group.add("-y", "A:B[:N]", request.y, parse_range, "range of y, likewise");
  add_parameter_ranges(group, request);
  group.add("--samples", "N", request.samples, count_between(2, kMostSamplesOfCurve), "formula: points per curve",
            "5 between curves");
  group.add("--every", "N", request.every, count_between(1, kMostSamplesOfCurve),
            "grid: a curve at every Nth row and column", "60 curves each way");
  group.add("--z-scale", "K", request.z_scale, parse_positive, "scale factor for the heights of surfaces", "1");
  group.add("--z-range", "A:B", request.z_range, parse_heights, "clip surfaces to heights A to B");
}

constexpr const char* kDrawExamples = R"(Examples:
  ligne draw gearbox.obj -o gearbox.svg
  ligne draw flange.glb --view front --scale 1:2 --unit m --hidden dashed --page A3 -o flange.pdf
  ligne draw houses.json --grid terrain.asc --every 4 --view iso -o village.svg
  ligne draw tower.obj --eye 9,6,14 --fov 40 -q -o - --format svg | rsvg-convert -z 2 > tower.png)";

void add_profile_option(CLI::App& app, std::optional<ProfileKind>& profile) {
  OptionGroup(app, "Lines")
      .add("--profile", "HOW", profile, parse_profile,
           "draw outer outlines wider, in their own layer. off; sheet: where only the sheet is behind; parts: also in front "
           "of other objects",
           "off; sheet where --edges names profile");
}

void add_frame_options(CLI::App& app, DrawOptions& options) {
  constexpr unsigned kMostFrames = 100'000;
  constexpr double kMostDegrees = 36'000;
  OptionGroup group(app, "View");
  const Option frames =
      group.add("--frames", "N", options.frames.count, count_between(2, kMostFrames),
                "N views of the rotating model: files -o name%03d.svg, or the pages of one PDF", "one view");
  const Option turn =
      group
          .add(
              "--turn", "DEG", options.frames.turn_degrees,
              [](const std::string& text) { return parse_within(text, -kMostDegrees, kMostDegrees, "degrees"); },
              "total rotation over all frames, counter-clockwise as seen from above", "360")
          .needs(frames);
  const Option to = group.add("--to", "X,Y,Z", options.last_eye, parse_point,
                              "with --eye and --frames: end of the straight path of the eye");
  to.needs(frames).excludes({turn});
  group
      .add("--path", "FILE", options.path, parse_file_name,
           "with --eye and --frames: path of the eye, a table of points X Y Z; the eye looks ahead, or at --target")
      .needs(frames)
      .excludes({to, turn});
}

/// The path of the eye, if it moves.
void set_eye_path(const DrawOptions& options, FrameRequest& frames, RunReport& run) {
  const std::optional<Point3>& eye = options.picture.view.eye;
  if (options.last_eye) {
    if (!eye) throw UsageError("--to", "needs --eye, the start of the path");
    frames.eyes = {*eye, *options.last_eye};
  }
  if (options.path.empty()) return;
  if (!eye) throw UsageError("--path", "needs --eye, the start of the path");
  frames.eyes = {*eye};
  frames.looks_ahead = !options.picture.view.target;
  Warnings warnings;
  for (const std::vector<Point3>& line : read_lines(options.path, run.files, warnings))
    frames.eyes.insert(frames.eyes.end(), line.begin(), line.end());
  for (std::string& line : warnings.lines()) run.warnings.push_back({options.path, std::move(line)});
  const bool has_places = frames.eyes.size() > 1 &&
                          std::ranges::none_of(frames.eyes, [](const Point3& p) { return std::isnan(p.x + p.y + p.z); });
  if (!has_places) throw InputError(printable(options.path, kLongestPath), "has no rows of points X Y Z");
}

void add_zbuffer_options(CLI::App& app, DrawOptions& options) {
  OptionGroup group(app, "Methods");
  group.add("--zbuffer-add", "FILE", options.zbuffer_add, parse_file_name,
            "zbuffer: add the models to the depth buffer in FILE, without painting its scene again");
  group.add("--zbuffer-save", "FILE", options.zbuffer_save, parse_file_name,
            "zbuffer: save buffer, models, view and page to FILE for --zbuffer-add");
}

/// Refuses depth buffers with other methods, several views, or surfaces.
void check_zbuffer(const DrawOptions& options, PictureRequest& request) {
  const char* const field = !options.zbuffer_add.empty() ? "zbuffer-add" : "zbuffer-save";
  if (options.zbuffer_add.empty() && options.zbuffer_save.empty()) return;
  const Method* const zbuffer = find_method("zbuffer");
  if (!request.lines.method) request.lines.method = zbuffer;
  if (request.lines.method != zbuffer) throw RequestError(field, "needs --method zbuffer");
  if (options.frames.count > 1) throw RequestError(field, "works for a single view only");
  if (has_surfaces(options.surfaces)) throw RequestError(field, "works for models only, not for surfaces");
}

/// The request that the options make. Throws before any file is read if it is wrong.
PictureRequest request_of(const DrawOptions& options, const MemoryLimit& memory) {
  PictureRequest request = options.picture;
  request.memory = memory;
  request.output.format = format_of(options.output);
  if (const std::string* file = compiled_file(options.model); file && !request.lines.method) {
    request.lines.method = method_of_compiled(*file);
  }
  check_zbuffer(options, request);
  choose_method_of_gray_faces(request);
  if (!options.method.edges_given && !request.fill.lights.empty()) request.lines.classes.add(LineClass::shadow);
  if (request.lines.profiles() != ProfileKind::off) request.lines.classes.add(LineClass::profile);
  check(request);
  if (options.frames.count > 1) {
    if (!options.plotter.preview.empty()) throw UsageError("--preview", "works for a single view only");
    if (options.plotter.choice.request.report) throw UsageError("--report", "works for a single view only");
  }
  check_mixed_scene(options.surfaces);
  request.lines.settings = settings_of(options.method, method_of(request));
  count_hidden(request.lines);
  if (!options.zbuffer_add.empty()) require_no_place(request, printable(options.zbuffer_add, kLongestPath));
  return request;
}

ZBuffer read_zbuffer(const std::string& file, InputFiles& opened) {
  return ZBuffer::read(read_input(file, file, opened), file);
}

/// Appends the models to those of the buffer.
void put_behind(const ZBuffer& buffer, LoadedModels& models) {
  const std::vector<std::string> names = object_names(buffer.scene());
  models.object_names.insert(models.object_names.begin(), names.begin(), names.end());
  models.scene = buffer.joined(std::move(models.scene));
  models.topology.reset();
}

/// The drawn part of the model if it is to be streamed. Updates `request` with what else must be computed.
std::optional<LoadedModels> stream(const DrawOptions& options, const ModelRequest& model, PictureRequest& request,
                                   RunReport& run, RunFiles& files) {
  const bool one_picture = options.frames.count == 1 && options.zbuffer_add.empty() && options.zbuffer_save.empty() &&
                           !has_surfaces(options.surfaces);
  if (!one_picture) {
    if (options.streaming != Streaming::on) return std::nullopt;
    throw RequestError("stream", "works for a single picture of a single model only");
  }
  const std::unique_ptr<TriangleFile> file = file_to_stream(options.streaming, model, request);
  if (!file) return std::nullopt;
  files.were_read(file->report().files);
  std::string why;
  std::optional<StreamedModel> streamed = stream_model(*file, request, run, why);
  if (!streamed) {
    if (options.streaming != Streaming::on) return std::nullopt;
    throw RequestError("stream", printable(file->name(), kLongestPath) + " can not be streamed: " + why);
  }
  request.lines.method = find_method("appel");
  request.blank = std::move(streamed->blank);
  if (!options.run.quiet) warn(streamed->models.files.front().name, streamed->models.files.front().warnings);
  return std::move(streamed->models);
}

LoadedModels load(const DrawOptions& options, const ModelRequest& model, PictureRequest& request, RunReport& run,
                  RunFiles& files) {
  if (std::optional<LoadedModels> streamed = stream(options, model, request, run, files)) return std::move(*streamed);
  return timed(run.stages, reading_of(options.model),
               [&] { return load_models(model, options.run.quiet, files, shows_materials(request)); });
}

/// Warns after the picture is made, so that an error message stands alone.
void warn_of_use(const DrawOptions& options, const PictureRequest& request) {
  if (options.run.quiet) return;
  warn_of_suffix(options.output);
  warn_of_idle_options({"draw", options.run.given, request.output.format, request.plotter.by_pens()});
}

void draw(const DrawOptions& options, PictureRequest request) {
  const bool as_pages = request.output.format == OutputFormat::pdf && !has_number_place(*options.output.file);
  const std::vector<std::string> outputs = numbered_names(*options.output.file, as_pages ? 1 : options.frames.count);
  RunFiles files;
  for (const std::string& name : outputs) files.will_write("--output", name);
  files.will_write("--preview", options.plotter.preview);
  files.will_write("--zbuffer-save", options.zbuffer_save);
  files.will_write("--stats-json", options.run.stats_json);
  RunReport run;
  request.plotter = plotter_request(options.plotter.choice, request.output.format, run.files);
  files.were_read(run.files);
  ModelRequest model = options.model;
  model.quality = request.lines.quality;
  model.shading = needs_creases(request.lines.studied());
  model.unit_mm = request.page.unit_mm;
  model.tell_parts =
      request.output.group_objects || !request.output.colors.empty() || !request.plotter.pens.pen_of_object.empty();
  LoadedModels models = load(options, model, request, run, files);
  add_surfaces(options.surfaces, models, request, run);
  files.were_read(run.files);
  ZBuffer buffer;
  if (!options.zbuffer_add.empty()) {
    buffer = timed(run.stages, "read buffer", [&] { return read_zbuffer(options.zbuffer_add, run.files); });
    files.were_read(run.files);
    put_behind(buffer, models);
  }
  require_parts(models, request);
  request.plotter.fit_drawing = !request.page.scale;
  report_healing(models, model, run);
  if (models.compiled_for && models.compiled_for == request.lines.method) {
    require_no_parameters(models, names_of(options.method));
    request.compiled = models.compiled;
  }
  ProgressBar bar(options.run);
  request.progress = bar.callback();
  const std::string place = shown_input(options.model.files.front());
  if (options.frames.count == 1) {
    const bool with_buffer = !options.zbuffer_add.empty() || !options.zbuffer_save.empty();
    Picture picture = with_buffer ? buffer.draw(std::move(models.scene), request, run)
                                  : draw_scene(models.scene, request, run, {}, std::move(models.topology));
    if (!options.zbuffer_save.empty()) files.write(options.zbuffer_save, buffer.write());
    warn_of_use(options, request);
    deliver(std::move(picture), {outputs.front(), options.plotter.preview, place}, options.run, run, files);
    return;
  }
  std::size_t frame = 0;
  FrameRequest frames = options.frames;
  frames.as_pages = as_pages;
  set_eye_path(options, frames, run);
  files.were_read(run.files);
  draw_frames(models.scene, request, frames, run, std::move(models.topology),
              [&](Picture picture) { files.write(outputs[frame++], std::move(picture.bytes)); });
  warn_of_use(options, request);
  report_warnings(run, place, options.run);
  finish(options.run, run, files);
}

}  // namespace

void setup_draw(CLI::App& app, DrawOptions& options) {
  CLI::App& draw = *add_command(app, "draw", "Draw meshes and polygon scenes with hidden lines removed", kDrawExamples);
  PictureRequest& picture = options.picture;
  add_model_options(draw, options.model);
  add_part_drawing_options(draw, picture.output);
  add_profile_option(draw, picture.lines.profile);
  add_view_options(draw, picture.view);
  add_frame_options(draw, options);
  add_line_options(draw, picture.lines, options.method);
  add_zbuffer_options(draw, options);
  add_fill_options(draw, picture.fill);
  add_mixed_scene_options(draw, options.surfaces);
  add_page_options(draw, picture.page);
  add_output_options(draw, options.output);
  add_dpi_option(draw, picture.output.dpi);
  add_curves_option(draw, picture.output.curves, "on; off with --quality exact");
  add_title_option(draw, picture.output.title, "title in the metadata of an SVG or PDF; not drawn");
  OptionGroup faces(draw, "Faces");
  faces.add_flag("--shade", picture.gray_faces,
                 "grey faces, lit from the eye, by a method with spans or pixels; without --method by watkins");
  faces.add(
      "--shade-tone", "HOW", picture.gray_tone, parse_gray_tone,
      "with --shade and --fill shade; face: one tone per face; smooth: continuous over smooth surfaces, as an image of --dpi",
      "face");
  add_hatch_options(draw, picture.hatch);
  add_plotter_options(draw, options.plotter);
  add_run_options(draw, options.run);
  OptionGroup(draw, "Work")
      .add("--stream", "HOW", options.streaming, parse_word<Streaming>(kStreamingNames),
           "read binary STL and PLY (with --quality exact) in several passes instead of into memory: on, off; auto: if the "
           "model would take more than half of --max-memory",
           "auto");
}

void run_draw(const DrawOptions& options) {
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { draw(options, request_of(options, memory)); });
}

}  // namespace ligne
