#pragma once
/// The command line of the experiments.

#include <string>
#include <vector>

#include "cli/options/option_groups.hpp"
#include "studies/experiments.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct StudyCommandOptions {
  std::vector<std::string> words;  ///< name of the experiment, then model files
  bool list = false;
  std::string json, csv, svg, plates;  ///< file names; empty: not written
  studies::StudySize size = studies::StudySize::full;
  RunOptions run;
};

/// Adds the command `study` with its options; `options` must outlive the parse.
void setup_study(CLI::App& app, StudyCommandOptions& options);

/// Runs `ligne-study`. Exit status: 0 done, 1 the input or the work failed, 2 the command line is wrong. Throws nothing.
int run_study_command_line(int argc, char** argv);

}  // namespace ligne
