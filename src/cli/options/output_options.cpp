#include "cli/options/output_options.hpp"

#include "cli/messages.hpp"
#include "cli/options/options.hpp"
#include "files/message_text.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "plotting/page.hpp"

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

void add_plotter_options(CLI::App& app, PlotterOptions& options) {
  PlotterChoice& choice = options.choice;
  PlotterRequest& request = choice.request;
  OptionGroup group(app, "Plotter");
  const Option device =
      group.add("--device", "NAME", choice.device, parse_file_name, "the plotter; ligne devices lists the names")
          .standard("cutter for HPGL, grbl-servo for G-code");
  const Option device_file =
      group.add("--device-file", "FILE", choice.device_file, parse_file_name, "TOML file that describes a plotter");
  group.add_flag("--fit-device", request.fit_device, "shift and scale down the drawing to fit the device's limits");
  group.add("--pens", "FILE", choice.pens_file, parse_file_name, "TOML file of pens and the layers that each draws");
  group.add_repeatable(
      "--pen", "TEXT", [&request](const std::string& text) { add_pen(request.pens, text); },
      "CLASS=N[,COLOUR[,WIDTH]]: draw a line class, material:NAME, object:NAME, shade:N or the rest with pen N; repeatable");
  group
      .add(
          "--optimize", "HOW", request.optimize,
          [](const std::string& t) { return static_cast<Optimize>(parse_choice(t, kOptimizeNames)); },
          "off; order: sort strokes to shorten travel; join: draw overlapping lines once and join ends; full: both")
      .standard("full for pens");
  const auto length = [](const std::string& t) { return parse_length_mm(t); };
  group.add("--join", "LEN", request.tolerances.ends_mm, length, "join ends within LEN of each other").standard("0.05mm");
  group
      .add("--simplify", "LEN", request.tolerances.simplify_mm, length,
           "largest distance by which simplifying may move a line")
      .standard("0.01mm");
  group.add_flag("--report", request.report,
                 "print strokes, lengths, lifts and time before and after optimization to standard error");
  const auto parse_preview = [&request](const std::string& text) {
    request.preview = true;
    return parse_file_name(text);
  };
  group.add("--preview", "FILE", options.preview, parse_preview,
            "write an SVG of the pen's path: colours show the order, travel is grey");
  device.excludes({device_file});
}

}  // namespace ligne
