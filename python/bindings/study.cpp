#include <string>
#include <vector>

#include "bindings/drawing.hpp"
#include "bindings/values.hpp"
#include "picture/errors.hpp"
#include "picture/parse/parse.hpp"
#include "plotting/writers/output_file.hpp"
#include "studies/run_experiments.hpp"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace ligne::python {
namespace {

using namespace studies;

/// The experiments and their output.
struct StudyKeywords {
  StudySize size = StudySize::full;
  std::string svg, csv;  ///< files, or empty
  unsigned threads = 0;
};

StudyKeywords study_keywords(const py::dict& keywords) {
  StudyKeywords given;
  for_each_option(keywords, [&](const std::string& name, py::handle value) {
    if (name == "size") {
      given.size = static_cast<StudySize>(parse_choice(text_of(name, value), kStudySizeNames));
    } else if (name == "svg") {
      given.svg = parse_file_name(text_of(name, value));
    } else if (name == "csv") {
      given.csv = parse_file_name(text_of(name, value));
    } else if (name == "threads") {
      given.threads = threads_of(value);
    } else {
      throw RequestError(name, "there is no such option");
    }
  });
  return given;
}

std::string study(const std::string& name, const std::vector<std::string>& models, const py::dict& keywords,
                  const py::object& progress) {
  const StudyKeywords given = study_keywords(keywords);
  const std::vector<const Experiment*> list = experiments_of(name);
  if (list.empty()) throw RequestError("name", "there is no experiment " + name + "; see experiments()");
  std::string text;
  run(progress, given.threads, [&](const Progress& report) {
    InputFiles opened;
    const std::vector<NamedScene> scenes = read_models(models, opened);
    const std::vector<Outcome> outcomes = run_experiments(list, {given.size, scenes}, report);
    OutputFiles files;
    if (!given.csv.empty()) files.add(given.csv, csv_of(outcomes));
    if (!given.svg.empty()) {
      const std::vector<Chart> charts = charts_of(outcomes);
      if (charts.empty()) throw RequestError("svg", name + " has no plot");
      files.add(given.svg, charts_svg(charts));
    }
    text = json_of(outcomes, given.size);
    files.commit();
  });
  return text;
}

/// (name, section, title) per experiment.
std::vector<std::vector<std::string>> list_experiments() {
  std::vector<std::vector<std::string>> list;
  for (const Experiment& e : experiments()) {
    list.push_back({std::string(e.name), std::string(e.section), std::string(e.title)});
  }
  return list;
}

}  // namespace

void add_study(py::module_& module) {
  module.def("study", &study, py::arg("name"), py::arg("models"), py::arg("options"), py::arg("progress"));
  module.def("experiments", &list_experiments);
}

}  // namespace ligne::python
