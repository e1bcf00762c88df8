#pragma once
/// Options that say where the result goes.

#include <optional>
#include <string>

#include "picture/requests.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct OutputOptions {
  std::optional<std::string> file;  ///< "-" is standard output
  std::optional<OutputFormat> format;
};

/// Adds -o and --format. `formats` is the help text of the latter: what there is, and the default.
void add_output_options(CLI::App& app, OutputOptions& options,
                        const std::string& formats = "svg pdf png json hpgl gcode (default: by the suffix)");

/// Adds --dpi.
void add_dpi_option(CLI::App& app, double& dpi);

/// Adds --curves. `standard` is the help text of the default.
void add_curves_option(CLI::App& app, std::optional<bool>& curves, const std::string& standard);

/// Adds --title.
void add_title_option(CLI::App& app, std::string& title, const std::string& help);

/// Warns where the file is written in another format than its name says.
void warn_of_suffix(const OutputOptions& options);

/// The format: as given, else by the suffix of the file. Throws UsageError when it can not be known.
OutputFormat format_of(const OutputOptions& options);

}  // namespace ligne
