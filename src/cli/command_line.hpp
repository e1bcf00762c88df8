#pragma once
/// The command line as a function: parses the arguments, runs the command, reports errors on standard error.

namespace ligne {

/// Exit status: 0 done, 1 the input or the work failed, 2 the command line is wrong. Throws nothing, and leaves no limit and
/// no handler behind, so that a program may call it many times.
int run_command_line(int argc, char** argv);

}  // namespace ligne
