#pragma once
/// ligne plot: a drawing from a file, made ready for pens.

#include <string>

#include "cli/output_options.hpp"
#include "cli/plotter_options.hpp"
#include "cli/run_options.hpp"
#include "picture/plot_drawing.hpp"

namespace ligne {

struct PlotCommandOptions {
  std::string drawing;  ///< file
  PlotDrawingRequest request;
  OutputOptions output;
  PlotterOptions plotter;
  RunOptions run;
};

void setup_plot(CLI::App& app, PlotCommandOptions& options);

/// Throws UsageError, RequestError, InputError, std::runtime_error.
void run_plot(const PlotCommandOptions& options);

}  // namespace ligne
