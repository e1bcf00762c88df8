/// The program `ligne-study`, which `ligne study` runs.

#include <csignal>

#include "studies/command.hpp"

int main(int argc, char** argv) {
  // A reader that goes away early is an error of the write, not a signal.
  std::signal(SIGPIPE, SIG_IGN);
  return ligne::run_study_command_line(argc, argv);
}
