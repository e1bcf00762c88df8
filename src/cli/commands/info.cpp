#include "cli/commands.hpp"

#include "cli/messages.hpp"
#include "cli/options/options.hpp"
#include "cli/options/picture_options.hpp"
#include "files/named_input.hpp"
#include "picture/check_request.hpp"
#include "picture/products.hpp"
#include "report/scene_info.hpp"

namespace ligne {
namespace {

void check(const InfoOptions& options) {
  check(options.page);
  if (options.output.format && *options.output.format != OutputFormat::json) {
    throw UsageError("--format", "info is written as text, or as json");
  }
}

void inform(const InfoOptions& options) {
  const std::string output = options.output.file.value_or("-");
  RunFiles files;
  files.will_write("--output", output);
  files.will_write("--stats-json", options.run.stats_json);
  RunReport run;
  PictureRequest request;
  request.lines = options.lines;
  request.lines.settings = settings_of(options.method, method_of(request));
  count_hidden(request.lines);
  ModelRequest model = options.model;
  model.quality = options.lines.quality;
  model.unit_mm = options.page.unit_mm;
  const LoadedModels models =
      timed(run.stages, reading_of(options.model), [&] { return load_models(model, options.run.quiet, files); });
  const SceneInfo info = scene_info(models, options.view, options.lines, options.page, run);
  if (!options.run.quiet) {
    for (const RunWarning& w : run.warnings) warn(shown_input(options.model.files.front()), w.text);
  }
  const bool json = options.json || options.output.format.has_value();
  files.write(output, json ? info_json(models, info) : info_text(models, info));
  finish(options.run, run, files);
}

}  // namespace

void setup_info(CLI::App& app, InfoOptions& options) {
  CLI::App& info =
      *add_command(app, "info", "Describe a scene and how each method can draw it",
                   "Examples:\n  ligne info gearbox.obj\n  ligne info flange.glb --view top --json -o flange.json");
  add_model_options(info, options.model);
  OptionGroup(info, "Output").add_flag("--json", options.json, "write JSON");
  add_view_options(info, options.view);
  add_line_options(info, options.lines, options.method);
  add_page_options(info, options.page);
  add_output_options(info, options.output, "json (default: text)");
  add_run_options(info, options.run);
}

void run_info(const InfoOptions& options) {
  check(options);
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { inform(options); });
}

}  // namespace ligne
