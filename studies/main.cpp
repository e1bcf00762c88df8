/// The program `ligne-study`, which `ligne study` runs.

#include <csignal>

#include "studies/command.hpp"

int main(int argc, char** argv) {
  // A closed pipe is reported as a write error, not as a signal.
  std::signal(SIGPIPE, SIG_IGN);
  return ligne::run_study_command_line(argc, argv);
}
