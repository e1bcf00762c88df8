#include "studies/run_experiments.hpp"

#include <filesystem>

#include "scene/readers/reader.hpp"

namespace ligne::studies {

std::vector<const Experiment*> experiments_of(std::string_view name) {
  std::vector<const Experiment*> list;
  if (const Experiment* one = find_experiment(name)) {
    list.push_back(one);
  } else if (name == "all") {
    for (const Experiment& e : experiments()) list.push_back(&e);
  }
  return list;
}

std::vector<NamedScene> read_models(std::span<const std::string> files, InputFiles& opened) {
  std::vector<NamedScene> models;
  for (const std::string& file : files) {
    Warnings warnings;
    ReadReport report;
    models.push_back({std::filesystem::path(file).stem().string(), read_scene(file, {}, warnings, &report)});
    opened.insert(opened.end(), report.files.begin(), report.files.end());
  }
  return models;
}

std::vector<Outcome> run_experiments(std::span<const Experiment* const> list, const StudyRequest& request,
                                     const std::function<void(double)>& progress) {
  std::vector<Outcome> outcomes;
  for (const Experiment* experiment : list) {
    if (progress) progress(double(outcomes.size()) / double(list.size()));
    outcomes.push_back({experiment, experiment->run(request)});
  }
  if (progress) progress(1);
  return outcomes;
}

std::vector<Chart> charts_of(std::span<const Outcome> outcomes) {
  std::vector<Chart> charts;
  for (const Outcome& outcome : outcomes)
    charts.insert(charts.end(), outcome.result.charts.begin(), outcome.result.charts.end());
  return charts;
}

}  // namespace ligne::studies
