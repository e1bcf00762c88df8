/// The command `ligne`.

#include <csignal>

#include "cli/command_line.hpp"

int main(int argc, char** argv) {
  // A closed pipe is reported as a write error, not as a signal.
  std::signal(SIGPIPE, SIG_IGN);
  return ligne::run_command_line(argc, argv);
}
