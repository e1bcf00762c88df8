#pragma once
/// `ligne study`: a program of its own, `ligne-study`, which repeats the experiments of the sources.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ligne {

inline constexpr const char* kStudyTitle = "The experiments of the sources, made again";

/// Adds the name of the command to the list of commands.
void add_study_command(CLI::App& app);

/// Runs `ligne-study`, from the folder of this program or else from PATH, with these arguments. Returns its exit status, or
/// 128 + the signal that ended it. Throws std::runtime_error if there is no such program.
int run_study_program(const std::vector<std::string>& arguments);

}  // namespace ligne
