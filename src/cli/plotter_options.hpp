#pragma once
/// Options of pens and plotters.

#include <memory>
#include <optional>
#include <string>

#include "cli/output_options.hpp"
#include "cli/run_files.hpp"
#include "plotting/device.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/pens.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct PlotterOptions {
  std::optional<Optimize>
      optimize;  ///< nothing: full for pens; other drawings stay as they were made, lines once and joined
  JoinTolerances tolerances;
  bool report = false;
  std::string device, device_file;  ///< empty: not given
  bool fit_device = false;
  std::string pens_file;
  PenTable pens;  ///< of --pen
  std::string preview;
};

void add_plotter_options(CLI::App& app, PlotterOptions& options);

/// What the options come to for an output format.
struct PlotterSetup {
  PlotterOptions options;
  std::shared_ptr<const Device> device;  ///< nullptr: an SVG or PDF for no device
  PenTable pens;

  /// The drawing is dealt out to pens.
  bool by_pens() const { return device || !pens.empty(); }
  Optimize optimize() const { return options.optimize.value_or(by_pens() ? Optimize::full : Optimize::off); }
};

/// Finds the device, reads its file and that of the pens, and tells `files` of them. Throws UsageError for options that do
/// not go with the format or with each other, std::runtime_error for a bad file.
PlotterSetup plotter_setup(const PlotterOptions& options, OutputFormat format, RunFiles& files);

}  // namespace ligne
