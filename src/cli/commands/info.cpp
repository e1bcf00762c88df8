#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/options/options.hpp"
#include "files/named_input.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/products.hpp"
#include "picture/requests.hpp"
#include "plotting/writers/output_file.hpp"
#include "report/listing.hpp"
#include "report/scene_info.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

std::vector<const Method*> chosen(const std::vector<std::string>& names) {
  const std::span<const Method* const> all = all_methods();
  std::vector<const Method*> methods(all.begin(), names.empty() ? all.end() : all.begin());
  for (const std::string& name : names) {
    try {
      methods.push_back(parse_method(name));
    } catch (const std::invalid_argument& e) {
      throw UsageError("methods", e.what());
    }
    if (!methods.back()) methods.back() = &default_method();
  }
  return methods;
}

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

void setup_devices(CLI::App& app, DevicesOptions& options) {
  CLI::App* command =
      add_command(app, "devices", "List the plotters: language, papers, limits, speed", "Example:\n  ligne devices --json");
  OptionGroup(*command, "Options").add_flag("--json", options.json, "write JSON");
}

void run_devices(const DevicesOptions& options) { write_output("-", options.json ? devices_json() : devices_text()); }

void setup_methods(CLI::App& app, MethodsOptions& options) {
  CLI::App* methods = add_command(app, "methods", "List the visibility methods: products, precision, paper",
                                  "Examples:\n  ligne methods warnock\n  ligne methods --json");
  add_arguments(*methods, "METHOD", options.names, false, "methods to list, with their experimental settings (--set)");
  OptionGroup(*methods, "Options").add_flag("--json", options.json, "write JSON");
}

void run_methods(const MethodsOptions& options) {
  const std::vector<const Method*> methods = chosen(options.names);
  write_output("-", options.json ? methods_json(methods) : methods_text(methods, !options.names.empty()));
}

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
