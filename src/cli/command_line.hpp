#pragma once
/// The command line as a function: parses the arguments, runs the command, reports errors on standard error.

#include <functional>

namespace CLI {
class App;
}

namespace ligne {

/// Exit status: 0 done, 1 the input or the work failed, 2 the command line is wrong. Throws nothing. Restores limits and
/// handlers, so that a program may call it repeatedly.
int run_command_line(int argc, char** argv);

/// A command of `ligne` that is a separate program.
struct CommandProgram {
  const char* name;                    ///< name of the command
  std::function<void(CLI::App&)> add;  ///< adds the command, with its options, to the program
  std::function<void()> run;           ///< runs the command after parsing
};

/// Parses the arguments of such a program and runs it. Exit status as for run_command_line(); throws nothing.
int run_command_program(const CommandProgram& program, int argc, char** argv);

}  // namespace ligne
