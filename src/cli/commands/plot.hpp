#pragma once
/// ligne plot: prepares drawings from files for pen plotters.

#include <optional>
#include <string>
#include <vector>

#include "cli/options/output_options.hpp"
#include "cli/options/plotter_options.hpp"
#include "cli/options/run_options.hpp"
#include "picture/pages/plot_drawing.hpp"

namespace ligne {

struct PlotCommandOptions {
  std::vector<std::string> drawings;  ///< files
  PlotDrawingRequest request;
  std::string occlude;  ///< text of the option; empty: not given, "true": the flag alone
  OutputOptions output;
  std::optional<bool> curves;
  PlotterOptions plotter;
  RunOptions run;
};

void setup_plot(CLI::App& app, PlotCommandOptions& options);

/// Throws UsageError, RequestError, InputError, std::runtime_error.
void run_plot(const PlotCommandOptions& options);

}  // namespace ligne
