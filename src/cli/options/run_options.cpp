#include "cli/options/run_options.hpp"

#include <cstdio>
#include <utility>

#include "cli/messages.hpp"
#include "cli/options/options.hpp"
#include "picture/pages/frames.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"

namespace ligne {
namespace {

constexpr unsigned kMostThreads = 1024;

}  // namespace

void add_run_options(CLI::App& app, RunOptions& options) {
  OptionGroup group(app, "Work");
  group.add(
      "--threads", "N", options.threads, [](const std::string& text) { return parse_count(text, 1, kMostThreads); },
      "number of threads (default: all cores)");
  group
      .add("--max-memory", "SIZE", options.max_memory, parse_memory,
           "stop with an error above this memory, such as 500M or 2G; none: no limit")
      .standard("three quarters of the machine's");
  group.add_flag("--stats", options.stats, "print counts and times of the method to standard error");
  group.add("--stats-json", "FILE", options.stats_json, parse_file_name, "write the counts and times to FILE as JSON");
  group
      .add(
          "--progress", "WHEN", options.progress,
          [](const std::string& text) { return static_cast<ShowProgress>(parse_choice(text, kShowProgressNames)); },
          "show progress: auto always never; auto: on a terminal, if the work takes long")
      .standard("auto");
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

}  // namespace ligne
