#pragma once
/// ligne methods: what visibility methods there are.

#include <string>
#include <vector>

#include "visibility/method.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct MethodsOptions {
  bool json = false;
};

void setup_methods(CLI::App& app, MethodsOptions& options);
void run_methods(const MethodsOptions& options);

/// Names of what a method produces, "strokes", "regions" and so on.
std::vector<std::string> product_names(std::uint8_t products);

/// "exact" or "resolution-limited".
std::string precision_name(const MethodTraits& traits);

}  // namespace ligne
