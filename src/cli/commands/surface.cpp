#include "cli/commands.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "cli/messages.hpp"
#include "cli/options/idle_options.hpp"
#include "cli/progress.hpp"
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

/// True for an option whose value is the next argument.
bool awaits_value(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-' && (argument[1] < '0' || argument[1] > '9') &&
         argument.find('=') == std::string::npos && argument != "--axes" && argument != "--stats" && argument != "--skirt" &&
         argument != "--north-arrow" && argument != "--legend";
}

}  // namespace

void protect_formulas(std::vector<std::string>& arguments) {
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

void setup_surface(CLI::App& app, SurfaceOptions& options) { add_surface_command(app, options); }

void run_surface(const SurfaceOptions& options) {
  const MemoryLimit memory = options.run.memory();
  run_within(memory, options.run.threads, [&] { run(options, checked_request(options, memory)); });
}

}  // namespace ligne
