#pragma once
/// ligne study: the experiments of the sources, made again.

#include <string>
#include <vector>

#include "cli/options/run_options.hpp"
#include "study/experiments.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct StudyCommandOptions {
  std::vector<std::string> words;  ///< the experiment's name, and files of models
  bool list = false;
  std::string json, csv, svg, plates;  ///< files, or empty
  studies::StudySize size = studies::StudySize::full;
  RunOptions run;
};

void setup_study(CLI::App& app, StudyCommandOptions& options);

/// Throws UsageError, InputError, std::runtime_error.
void run_study(const StudyCommandOptions& options);

}  // namespace ligne
