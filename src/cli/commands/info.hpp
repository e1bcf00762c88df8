#pragma once
/// ligne info: describes a scene and how each method can draw it.

#include "cli/options/method_options.hpp"
#include "cli/options/model_options.hpp"
#include "cli/options/output_options.hpp"
#include "cli/options/run_options.hpp"

namespace ligne {

struct InfoOptions {
  ModelRequest model;
  ViewRequest view;
  LineRequest lines;
  MethodChoice method;
  PageRequest page;
  OutputOptions output;  ///< default: text to standard output
  RunOptions run;
  bool json = false;
};

void setup_info(CLI::App& app, InfoOptions& options);

/// Throws UsageError, RequestError, InputError, std::runtime_error.
void run_info(const InfoOptions& options);

}  // namespace ligne
