#include <utility>

#include "cli/commands.hpp"
#include "cli/options/options.hpp"
#include "files/named_input.hpp"
#include "picture/errors.hpp"
#include "picture/models/compiled_model.hpp"
#include "picture/parse/parse.hpp"

namespace ligne {
namespace {

constexpr const char* kCompileExamples = R"(Examples:
  ligne compile gearbox.obj -o gearbox.tree
  ligne draw gearbox.tree --view front -o front.svg
  ligne draw gearbox.tree --frames 36 -o turn.pdf)";

void compile(const CompileOptions& options) {
  const MethodSettings settings = settings_of(options.choice, *options.method);
  if (!options.output) throw UsageError("--output", "there is no output file: -o FILE");
  if (const std::string* file = compiled_file(options.model)) {
    throw RequestError("", printable(*file, kLongestPath) + " is compiled already");
  }
  RunFiles files;
  files.will_write("--output", *options.output);
  files.will_write("--stats-json", options.run.stats_json);
  RunReport run;
  LoadedModels models =
      timed(run.stages, reading_of(options.model), [&] { return load_models(options.model, options.run.quiet, files); });
  report_healing(models, options.model, run);
  const CompiledModel model = compile_model(std::move(models.scene), *options.method, settings, run);
  std::string bytes = timed(run.stages, {"write", std::to_string(model.scene.faces.size()) + " faces"},
                            [&] { return write_compiled_model(model); });
  report_warnings(run, shown_input(options.model.files.front()), options.run);
  files.write(*options.output, std::move(bytes));
  finish(options.run, run, files);
}

}  // namespace

void setup_compile(CLI::App& app, CompileOptions& options) {
  CLI::App& command = *add_command(app, "compile", "Compile a model for drawing from any viewpoint", kCompileExamples);
  add_model_options(command, options.model);
  add_compile_options(command, options.method, options.choice);
  OptionGroup(command, "Lines")
      .add("--quality", "HOW", options.model.quality, parse_word<Quality>(kQualityNames),
           "clear: repair the model as for clear lines; exact: keep it as stored", "clear");
  OptionGroup(command, "Output")
      .add("-o,--output", "FILE", options.output, parse_file_name, "file to write; - is standard output");
  add_run_options(command, options.run);
}

void run_compile(const CompileOptions& options) {
  run_within(options.run.memory(), options.run.threads, [&] { compile(options); });
}

}  // namespace ligne
