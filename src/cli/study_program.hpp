#pragma once
/// `ligne study`: runs the separate program `ligne-study`, which repeats the experiments of the sources.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ligne {

inline constexpr const char* kStudyTitle = "Repeat the experiments of the published sources";

/// Adds the command to the list of commands.
void add_study_command(CLI::App& app);

/// Runs `ligne-study` from this program's folder, or else from PATH, with these arguments. Returns its exit status, or 128 +
/// the number of the signal that ended it. Throws std::runtime_error if it is not found.
int run_study_program(const std::vector<std::string>& arguments);

}  // namespace ligne
