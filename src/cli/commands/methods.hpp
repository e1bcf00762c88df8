#pragma once
/// ligne methods: what visibility methods there are.

namespace CLI {
class App;
}

namespace ligne {

struct MethodsOptions {
  bool json = false;
};

void setup_methods(CLI::App& app, MethodsOptions& options);
void run_methods(const MethodsOptions& options);

}  // namespace ligne
