#include "cli/commands.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "cli/options/options.hpp"

namespace ligne {
namespace {

constexpr const char* kProgram = "ligne-study";

/// The path of the program beside this one, or its bare name, which is searched in PATH.
std::string place_of_program() {
  std::error_code error;
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path beside = own.parent_path() / kProgram;
  return !error && access(beside.c_str(), X_OK) == 0 ? beside.string() : kProgram;
}

}  // namespace

void add_study_command(CLI::App& app) { add_command(app, "study", kStudyTitle, ""); }

int run_study_program(const std::vector<std::string>& arguments) {
  const std::string place = place_of_program();
  std::vector<char*> words{const_cast<char*>(kProgram)};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  pid_t child = 0;
  if (const int error = posix_spawnp(&child, place.c_str(), nullptr, nullptr, words.data(), environ); error != 0) {
    throw std::runtime_error("study: " + std::string(kProgram) +
                             " can not be run: " + std::generic_category().message(error));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error("study: " + std::string(kProgram) + " can not be waited for");
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace ligne
