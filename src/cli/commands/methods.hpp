#pragma once
/// ligne methods: lists the visibility methods.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ligne {

struct MethodsOptions {
  std::vector<std::string> names;  ///< empty: all methods
  bool json = false;
};

void setup_methods(CLI::App& app, MethodsOptions& options);
/// Throws UsageError, OutputError.
void run_methods(const MethodsOptions& options);

}  // namespace ligne
