#pragma once
/// Options for the output file and its format.

#include <optional>
#include <string>

#include "picture/pages/plotter.hpp"
#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct OutputOptions {
  std::optional<std::string> file;  ///< "-" is standard output
  std::optional<OutputFormat> format;
};

/// Adds -o and --format. `formats` is the help text of --format: the choices and the default.
void add_output_options(CLI::App& app, OutputOptions& options,
                        const std::string& formats = "svg pdf png json hpgl gcode (default: by the suffix)");

/// Adds --dpi.
void add_dpi_option(CLI::App& app, double& dpi);

/// Adds --curves. `standard` is the default shown in the help text.
void add_curves_option(CLI::App& app, std::optional<bool>& curves, const std::string& standard);

/// Adds --title.
void add_title_option(CLI::App& app, std::string& title, const std::string& help);

/// Warns if the suffix of the file names another format than --format.
void warn_of_suffix(const OutputOptions& options);

/// The format: --format, or else from the suffix of the file. Throws UsageError if neither determines it.
OutputFormat format_of(const OutputOptions& options);

/// Options for pens and plotters.
struct PlotterOptions {
  PlotterChoice choice;
  std::string preview;  ///< file name; empty: none
};

void add_plotter_options(CLI::App& app, PlotterOptions& options);

}  // namespace ligne
