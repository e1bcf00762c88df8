#include "studies/command.hpp"

#include <span>
#include <stdexcept>

#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/options/options.hpp"
#include "picture/parse/parse.hpp"
#include "studies/plates/plates.hpp"
#include "studies/run_experiments.hpp"

namespace ligne {
namespace {

using namespace studies;

constexpr const char* kStudyExamples = R"(Examples:
  ligne study --list
  ligne study squares --svg squares.svg
  ligne study coherence gearbox.obj --json coherence.json
  ligne study all --size small
  ligne study --plates plates.pdf)";

/// The chosen experiments. Throws UsageError before any work begins if the name is missing or unknown.
std::vector<const Experiment*> chosen(const StudyCommandOptions& options) {
  if (options.words.empty()) throw UsageError("there is no experiment: ligne study NAME, or all; see ligne study --list");
  const std::string& name = options.words.front();
  std::vector<const Experiment*> list = experiments_of(name);
  if (list.empty()) throw UsageError("there is no experiment " + name + "; see ligne study --list");
  return list;
}

void study_chosen(const StudyCommandOptions& options) {
  const bool only_plates = !options.plates.empty() && options.words.empty();
  const std::vector<const Experiment*> list = only_plates ? std::vector<const Experiment*>{} : chosen(options);
  RunFiles files;
  files.will_write("--plates", options.plates);
  files.will_write("--json", options.json);
  files.will_write("--csv", options.csv);
  files.will_write("--svg", options.svg);
  if (!options.plates.empty()) files.write(options.plates, plates_pdf(make_plates()));
  if (only_plates) return files.commit();
  InputFiles read;
  const std::vector<NamedScene> models = read_models(std::span(options.words).subspan(1), read);
  files.were_read(read);
  std::vector<Outcome> outcomes;
  {
    ProgressBar bar(options.run);
    outcomes = run_experiments(list, {options.size, models}, bar.callback());
  }
  std::string text;
  for (const Outcome& outcome : outcomes) text += (text.empty() ? "" : "\n") + text_of(outcome);
  if (!options.json.empty()) files.write(options.json, json_of(outcomes, options.size));
  if (!options.csv.empty()) files.write(options.csv, csv_of(outcomes));
  if (!options.svg.empty()) {
    const std::vector<Chart> charts = charts_of(outcomes);
    if (charts.empty()) throw std::runtime_error("--svg: " + options.words.front() + " has no plot");
    files.write(options.svg, charts_svg(charts));
  }
  files.commit();
  // The table goes to standard output only if no other output does.
  if (options.json != "-" && options.csv != "-" && options.svg != "-") write_output("-", text);
}

}  // namespace

void setup_study(CLI::App& app, StudyCommandOptions& options) {
  CLI::App& command = *add_command(app, "study", kStudyTitle, kStudyExamples);
  add_arguments(command, "NAME", options.words, false, "an experiment, or all; model files after the name are studied too");
  OptionGroup group(command, "Options");
  group.add_flag("--list", options.list, "list the experiments");
  group.add(
      "--size", "SIZE", options.size,
      [](const std::string& text) { return static_cast<StudySize>(parse_choice(text, kStudySizeNames)); },
      "full, or small: the same tables for smaller scenes", "full");
  group.add("--json", "FILE", options.json, parse_file_name, "write the tables as JSON; - is standard output");
  group.add("--csv", "FILE", options.csv, parse_file_name, "write the figures as CSV, one per line");
  group.add("--svg", "FILE", options.svg, parse_file_name, "write the plots, one below the other");
  group.add("--plates", "FILE", options.plates, parse_file_name,
            "write the redrawn plates of the thesis as a PDF; needs no NAME");
  add_run_options(command, options.run);
}

int run_study_command_line(int argc, char** argv) {
  StudyCommandOptions options;
  const auto add = [&options](CLI::App& app) { setup_study(app, options); };
  const auto run = [&options] {
    if (options.list) return write_output("-", list_of_experiments());
    run_within(options.run.memory(), options.run.threads, [&options] { study_chosen(options); });
  };
  return run_command_program({"study", add, run}, argc, argv);
}

}  // namespace ligne
