#pragma once
/// ligne plot: a drawing from a file, made ready for pens.

#include <optional>
#include <set>
#include <string>

#include "cli/output_options.hpp"
#include "cli/plotter_options.hpp"
#include "cli/run_options.hpp"
#include "plotting/drawing_reader.hpp"

namespace ligne {

struct PlotCommandOptions {
  std::string drawing;           ///< file
  std::optional<PageSize> page;  ///< nothing: that of the drawing
  bool landscape = false, portrait = false;
  double margin_mm = 10;
  std::optional<double> pen_width_mm;  ///< nothing: the widths of the drawing, and 0.35 mm where it tells none
  LineWidths widths_mm{};              ///< of layers by their names
  bool fit = false;                    ///< fill the page
  double scale = 1;
  std::set<std::string> skip;             ///< kinds of SVG content that may be left out
  std::optional<FillReading::How> fills;  ///< nothing: outline
  bool occlude = false;
  FillHatches hatches;
  bool hatches_given = false;  ///< how, so that fills are hatched
  double dpi = 150;
  OutputOptions output;
  PlotterOptions plotter;
  RunOptions run;
};

void setup_plot(CLI::App& app, PlotCommandOptions& options);

/// Throws UsageError, std::runtime_error.
void run_plot(const PlotCommandOptions& options);

}  // namespace ligne
