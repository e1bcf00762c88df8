#include "cli/commands.hpp"

#include "base/parallel.hpp"
#include "cli/console.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/options.hpp"
#include "files/named_input.hpp"
#include "picture/parse/parse.hpp"
#include "report/compare.hpp"
#include "report/compare_output.hpp"

namespace ligne {
namespace {

constexpr const char* kCompareExamples = R"(Examples:
  ligne compare gearbox.obj
  ligne compare gearbox.obj --methods appel,newell,warnock --edges all --html gearbox.html
  ligne compare houses.json --view front --csv -o houses.csv)";

void compare(const CompareOptions& options) {
  RunFiles files;
  files.will_write("--output", options.output);
  files.will_write("--html", options.html);
  files.will_write("--stats-json", options.run.stats_json);
  CompareRequest request{.methods = compared_methods(options.methods, named(options.method)),
                         .limit_seconds = options.limit_seconds};
  request.picture.view = options.view;
  request.picture.lines = options.lines;
  request.picture.page = options.page;
  request.picture.memory = options.run.memory();
  if (options.lines.most_hiding)
    throw UsageError("--hidden", "only --method appel counts faces, which dashed:N and solid:N need; see ligne draw");
  if (request.picture.lines.profiles() != ProfileKind::off) request.picture.lines.classes.add(LineClass::profile);
  check(request.picture);
  ModelRequest model = options.model;
  model.quality = options.lines.quality;
  model.unit_mm = options.page.unit_mm;
  RunReport run;
  const LoadedModels models =
      timed(run.stages, reading_of(options.model), [&] { return load_models(model, options.run.quiet, files); });
  report_healing(models, model, run);
  report_warnings(run, shown_input(options.model.files.front()), options.run);
  const Topology topology =
      timed(run.stages, "topology", [&] { return models.topology ? *models.topology : build_topology(models.scene); });
  ProgressBar bar(options.run);
  request.progress = bar.callback();
  const MethodComparison comparison =
      timed(run.stages, "compare", [&] { return compare_methods(models.scene, topology, request); });
  files.write(options.output, options.json  ? compare_json(comparison, options.model.files)
                              : options.csv ? compare_csv(comparison)
                                            : compare_text(comparison));
  if (!options.html.empty()) files.write(options.html, compare_page(comparison, shown_input(options.model.files.front())));
  finish(options.run, run, files);
}

}  // namespace

void setup_compare(CLI::App& app, CompareOptions& options) {
  CLI::App& command = *add_command(app, "compare", "Compare all methods on one scene", kCompareExamples);
  add_model_options(command, options.model);
  OptionGroup group(command, "Methods");
  group.add("--methods", "NAME,...", options.methods, parse_methods, "methods to compare; see ligne methods", "all");
  group.add(
      "--time-limit", "S", options.limit_seconds,
      [](const std::string& text) { return parse_within(text, 0, kMostLimitSeconds, "seconds"); },
      "time limit per method; slower methods are stopped", "60");
  OptionGroup output(command, "Output");
  const Option json = output.add_flag("--json", options.json, "write JSON");
  output.add_flag("--csv", options.csv, "write comma-separated values").excludes({json});
  output.add("--html", "FILE", options.html, parse_file_name,
             "write a self-contained HTML page with the drawings, differences in red, and tables");
  output.add("-o,--output", "FILE", options.output, parse_file_name, "file to write", "standard output");
  add_view_options(command, options.view);
  add_line_options(command, options.lines, options.method, false);
  add_page_options(command, options.page);
  add_run_options(command, options.run);
}

void run_compare(const CompareOptions& options) {
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { compare(options); });
}

}  // namespace ligne
