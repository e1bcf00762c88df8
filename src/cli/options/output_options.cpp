#include "cli/options/output_options.hpp"

#include "cli/messages.hpp"
#include "cli/options/options.hpp"
#include "files/message_text.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {

void add_output_options(CLI::App& app, OutputOptions& options, const std::string& formats) {
  OptionGroup group(app, "Output");
  group.add("-o,--output", "FILE", options.file, parse_file_name, "file to write; - is standard output");
  group.add("--format", "NAME", options.format, parse_format, formats);
}

void add_dpi_option(CLI::App& app, double& dpi) {
  OptionGroup(app, "Output").add("--dpi", "N", dpi, parse_dpi, "resolution of a PNG").standard("150");
}

void add_curves_option(CLI::App& app, std::optional<bool>& curves, const std::string& standard) {
  OptionGroup(app, "Output")
      .add(
          "--curves", "HOW", curves, [](const std::string& text) { return parse_choice(text, kSwitchNames) == 1; },
          "SVG, PDF, PNG: replace tessellated circles and ellipses by curves: on off")
      .standard(standard);
}

void add_title_option(CLI::App& app, std::string& title, const std::string& help) {
  OptionGroup(app, "Output")
      .add(
          "--title", "TEXT", title, [](const std::string& text) { return text; }, help);
}

void warn_of_suffix(const OutputOptions& options) {
  if (!options.file || !options.format || *options.file == "-") return;
  try {
    const OutputFormat named = format_of_suffix(*options.file);
    if (named == *options.format) return;
    const auto name = [](OutputFormat format) { return std::string(kOutputFormatNames[static_cast<std::size_t>(format)]); };
    warn(printable(*options.file, kLongestPath),
         "is written as " + name(*options.format) + " (--format), though its name is that of " + name(named));
  } catch (const std::invalid_argument&) {
    // A name without a known suffix suits all formats.
  }
}

OutputFormat format_of(const OutputOptions& options) {
  if (!options.file) throw UsageError("--output", "there is no output file: -o FILE, or -o - --format NAME");
  if (options.format) return *options.format;
  if (*options.file == "-") throw UsageError("--output", "standard output needs a --format: " + list_of(kOutputFormatNames));
  try {
    return format_of_suffix(*options.file);
  } catch (const std::invalid_argument& e) {
    throw UsageError("--output", e.what());
  }
}

}  // namespace ligne
