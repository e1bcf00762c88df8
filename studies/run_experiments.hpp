#pragma once
/// Experiments from their names, with models from files beside their own scenes.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_file.hpp"
#include "studies/results/result_text.hpp"

namespace ligne::studies {

/// The experiment of that name, or all of them for "all"; none for any other name.
std::vector<const Experiment*> experiments_of(std::string_view name);

/// One model of each file, under the file's name without folder and suffix; `opened` gets all files that were read. Throws
/// InputError.
std::vector<NamedScene> read_models(std::span<const std::string> files, InputFiles& opened);

/// Runs them one after the other; `progress`, which may be empty, is called with the fraction of them that is done.
std::vector<Outcome> run_experiments(std::span<const Experiment* const> list, const StudyRequest& request,
                                     const std::function<void(double)>& progress);

/// The plots of all of them; many have none.
std::vector<Chart> charts_of(std::span<const Outcome> outcomes);

}  // namespace ligne::studies
