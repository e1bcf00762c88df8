#pragma once
/// Runs experiments by name, with models from files beside their own scenes.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_file.hpp"
#include "studies/results/result_text.hpp"

namespace ligne::studies {

/// The experiment of that name, or all of them for "all"; empty for an unknown name.
std::vector<const Experiment*> experiments_of(std::string_view name);

/// One model per file, named by the file name without folder and extension; adds all files read to `opened`. Throws
/// InputError.
std::vector<NamedScene> read_models(std::span<const std::string> files, InputFiles& opened);

/// Runs the experiments in order. `progress`, if set, is called with the completed fraction.
std::vector<Outcome> run_experiments(std::span<const Experiment* const> list, const StudyRequest& request,
                                     const std::function<void(double)>& progress);

/// The charts of all outcomes. Many outcomes have none.
std::vector<Chart> charts_of(std::span<const Outcome> outcomes);

}  // namespace ligne::studies
