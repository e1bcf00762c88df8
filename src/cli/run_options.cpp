#include "cli/run_options.hpp"

#include <stdexcept>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "geometry/parallel.hpp"

namespace ligne {
namespace {

constexpr unsigned kMostThreads = 1024;

}  // namespace

void add_run_options(CLI::App& app, RunOptions& options) {
  CLI::Option* threads = add_parsed(
      app, "--threads", "N", options.threads, [](const std::string& text) { return parse_count(text, 1, kMostThreads); },
      "number of threads (default: all cores)");
  CLI::Option* stats = app.add_flag("--stats", options.stats, "counts and times of the method, to standard error");
  CLI::Option* stats_json = add_parsed(
      app, "--stats-json", "FILE", options.stats_json,
      [](const std::string& text) {
        if (text.empty()) throw std::invalid_argument("the name of the file is empty");
        return text;
      },
      "the same as JSON, to a file");
  CLI::Option* progress =
      add_parsed(
          app, "--progress", "WHEN", options.progress,
          [](const std::string& text) { return static_cast<ShowProgress>(parse_choice(text, kShowProgressNames)); },
          "auto always never; auto: long work on a terminal")
          ->default_str("auto");
  CLI::Option* quiet = app.add_flag("-q,--quiet", options.quiet, "no warnings, no progress");
  for (CLI::Option* option : {threads, stats, stats_json, progress, quiet}) option->group("Work");
}

void run_with_threads(const RunOptions& options, const std::function<void()>& work) {
  run_with_threads(options.threads, work);
}

}  // namespace ligne
