#pragma once
/// Times of the stages of a run, and how they and the method's own figures are told.

#include <chrono>
#include <string>
#include <utility>

#include "cli/run_files.hpp"
#include "cli/run_options.hpp"
#include "drawing/statistics.hpp"

namespace ligne {

/// Calls the work and adds its time under the name.
template <class Work>
auto timed(Statistics& stages, std::string name, Work&& work) {
  struct Clock {
    Statistics& stages;
    std::string name;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Clock() {
      stages.time(std::move(name), std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
  } clock{stages, std::move(name)};
  return std::forward<Work>(work)();
}

/// What a run has to tell. `study` is the method's own, `stages` that of the whole run.
struct RunReport {
  std::string method;
  Statistics study, stages;
};

/// As a table for people.
std::string report_text(const RunReport& report);

/// The end of a run: writes its counts and times where the options want them, and puts all files in their places.
void finish(const RunOptions& options, const RunReport& report, RunFiles& files);

/// As JSON: {"format": "ligne-stats", "version": 1, "method", "counts", "seconds", "stages"}.
std::string report_json(const RunReport& report);

}  // namespace ligne
