#pragma once
/// ligne compile: writes a model with the view-independent data of a method to a file that ligne draw reads.

#include <optional>
#include <string>

#include "cli/options/method_options.hpp"
#include "cli/options/model_options.hpp"
#include "cli/options/run_options.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct CompileOptions {
  ModelRequest model;
  const Method* method = nullptr;
  MethodChoice choice;
  std::optional<std::string> output;
  RunOptions run;
};

/// Adds the command; it runs when the command line names it. `options` must outlive the parse.
void setup_compile(CLI::App& app, CompileOptions& options);

/// Throws UsageError, RequestError, InputError, std::runtime_error.
void run_compile(const CompileOptions& options);

}  // namespace ligne
