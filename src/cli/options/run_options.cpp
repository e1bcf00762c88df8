#include <cstdio>
#include <system_error>
#include <utility>

#include "cli/console.hpp"
#include "cli/options/option_groups.hpp"
#include "cli/options/options.hpp"
#include "files/message_text.hpp"
#include "picture/pages/frames.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "plotting/page.hpp"
#include "report/run_json.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

bool are_one_file(const fs::path& a, const fs::path& b) {
  std::error_code absent;
  return fs::equivalent(a, b, absent) && !absent;
}

/// True if two paths, which need not exist yet, lead to one file.
bool will_be_one_file(const fs::path& a, const fs::path& b) {
  if (a == b || are_one_file(a, b)) return true;
  if (a == "-" || b == "-") return false;
  std::error_code a_error, b_error;
  const fs::path whole_a = fs::weakly_canonical(fs::absolute(a, a_error), a_error),
                 whole_b = fs::weakly_canonical(fs::absolute(b, b_error), b_error);
  return whole_a == whole_b && !a_error && !b_error;
}

void refuse_if_same(const std::string& option, const fs::path& written, const fs::path& read) {
  if (written == "-" || !are_one_file(written, read)) return;
  const std::string other = written == read ? "" : " (as " + printable(read.string()) + ")";
  throw UsageError(
      option, printable(written.string(), kLongestPath) + " is also an input file" + other + ", and would be overwritten");
}

constexpr unsigned kMostThreads = 1024;

}  // namespace

void RunFiles::will_write(const std::string& option, const fs::path& file) {
  if (file.empty()) return;
  for (const Written& other : written_) {
    if (!will_be_one_file(file, other.file)) continue;
    throw UsageError(option, printable(file.string(), kLongestPath) + " is the " +
                                 (other.option == "--output" ? "output file" : "file of " + other.option) + " too");
  }
  for (const fs::path& read : read_) refuse_if_same(option, file, read);
  written_.push_back({option, file});
}

void RunFiles::were_read(const InputFiles& files) {
  for (const fs::path& file : files) {
    for (const Written& output : written_) refuse_if_same(output.option, output.file, file);
  }
  read_.insert(read_.end(), files.begin(), files.end());
}

void add_run_options(CLI::App& app, RunOptions& options) {
  OptionGroup group(app, "Work");
  group.add("--threads", "N", options.threads, count_between(1, kMostThreads), "number of threads (default: all cores)");
  group.add("--max-memory", "SIZE", options.max_memory, parse_memory,
            "stop with an error above this memory, such as 500M or 2G; none: no limit", "three quarters of the machine's");
  group.add_flag("--stats", options.stats, "print counts and times of the method to standard error");
  group.add("--stats-json", "FILE", options.stats_json, parse_file_name, "write the counts and times to FILE as JSON");
  group.add("--progress", "WHEN", options.progress, parse_word<ShowProgress>(kShowProgressNames),
            "show progress: auto always never; auto: on a terminal, if the work takes long", "auto");
  group.add_flag("-q,--quiet", options.quiet, "print no warnings and no progress");
}

void report_warnings(const RunReport& report, const std::string& place, const RunOptions& options) {
  if (options.quiet) return;
  for (const RunWarning& w : report.warnings) warn(w.place.empty() ? place : w.place, w.text);
}

void deliver(Picture picture, const PictureNames& names, const RunOptions& options, RunReport& report, RunFiles& files) {
  files.were_read(report.files);
  report_warnings(report, names.place, options);
  std::fputs(picture.plotter_report.c_str(), stderr);
  if (!names.preview.empty()) files.write(names.preview, std::move(picture.preview));
  timed(report.stages, "output", [&] {
    for (PicturePart& part : picture.parts) {
      const std::string name = name_of(names.output, part);
      files.will_write("--output", name);
      files.write(name, std::move(part.bytes));
    }
    if (picture.parts.empty()) files.write(names.output, std::move(picture.bytes));
  });
  finish(options, report, files);
}

void finish(const RunOptions& options, const RunReport& report, RunFiles& files) {
  if (!options.stats_json.empty()) files.write(options.stats_json, report_json(report));
  check_memory_sufficed();
  files.commit();
  if (options.stats) std::fputs(report_text(report).c_str(), stderr);
}

void add_output_options(CLI::App& app, OutputOptions& options, const std::string& formats) {
  OptionGroup group(app, "Output");
  group.add("-o,--output", "FILE", options.file, parse_file_name, "file to write; - is standard output");
  group.add("--format", "NAME", options.format, parse_format, formats);
}

void add_dpi_option(CLI::App& app, double& dpi) {
  OptionGroup(app, "Output").add("--dpi", "N", dpi, parse_dpi, "resolution of a PNG", "150");
}

void add_curves_option(CLI::App& app, std::optional<bool>& curves, const std::string& standard) {
  OptionGroup(app, "Output")
      .add("--curves", "HOW", curves, parse_word<bool>(kSwitchNames),
           "SVG, PDF, PNG: replace tessellated circles and ellipses by curves: on off", standard);
}

void add_title_option(CLI::App& app, std::string& title, const std::string& help) {
  OptionGroup(app, "Output").add("--title", "TEXT", title, std::identity(), help);
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
  const Option device = group.add("--device", "NAME", choice.device, parse_file_name,
                                  "the plotter; ligne devices lists the names", "cutter for HPGL, grbl-servo for G-code");
  const Option device_file =
      group.add("--device-file", "FILE", choice.device_file, parse_file_name, "TOML file that describes a plotter");
  group.add_flag("--fit-device", request.fit_device, "shift and scale down the drawing to fit the device's limits");
  group.add("--pens", "FILE", choice.pens_file, parse_file_name, "TOML file of pens and the layers that each draws");
  group.add_repeatable(
      "--pen", "TEXT", [&request](const std::string& text) { add_pen(request.pens, text); },
      "CLASS=N[,COLOUR[,WIDTH]]: draw a line class, material:NAME, object:NAME, shade:N or the rest with pen N; repeatable");
  group.add("--optimize", "HOW", request.optimize, parse_word<Optimize>(kOptimizeNames),
            "off; order: sort strokes to shorten travel; join: draw overlapping lines once and join ends; full: both",
            "full for pens");
  group.add("--join", "LEN", request.tolerances.ends_mm, parse_length_mm, "join ends within LEN of each other", "0.05mm");
  group.add("--simplify", "LEN", request.tolerances.simplify_mm, parse_length_mm,
            "largest distance by which simplifying may move a line", "0.01mm");
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
