/// The command `ligne`.

#include <csignal>

#include "cli/command_line.hpp"

int main(int argc, char** argv) {
  // A reader that goes away early is an error of the write, not a signal.
  std::signal(SIGPIPE, SIG_IGN);
  return ligne::run_command_line(argc, argv);
}
