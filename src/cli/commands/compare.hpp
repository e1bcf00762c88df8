#pragma once
/// ligne compare: every method on one scene, side by side.

#include <string>
#include <vector>

#include "cli/options/method_options.hpp"
#include "cli/options/model_options.hpp"
#include "cli/options/run_options.hpp"

namespace ligne {

struct CompareOptions {
  ModelRequest model;
  ViewRequest view;
  LineRequest lines;
  MethodChoice method;
  std::vector<const Method*> methods;  ///< empty: all methods that produce lines
  double limit_seconds = 60;
  PageRequest page;
  std::string output = "-";
  std::string html;  ///< file name, or empty
  bool json = false, csv = false;
  RunOptions run;
};

void setup_compare(CLI::App& app, CompareOptions& options);

/// Throws UsageError, RequestError, InputError, std::runtime_error.
void run_compare(const CompareOptions& options);

}  // namespace ligne
