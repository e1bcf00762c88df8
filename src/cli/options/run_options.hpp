#pragma once
/// Options for the run: threads, memory, reports, progress.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/memory_limit.hpp"
#include "cli/run_files.hpp"
#include "picture/pages/write_picture.hpp"
#include "picture/run_report.hpp"

namespace CLI {
class App;
}

namespace ligne {

enum class ShowProgress { automatic, always, never };
inline constexpr std::string_view kShowProgressNames[] = {"auto", "always", "never"};

struct RunOptions {
  unsigned threads = 0;  ///< 0: all cores
  std::optional<MemoryLimit> max_memory;
  bool stats = false;
  std::string stats_json;  ///< file name, or empty
  ShowProgress progress = ShowProgress::automatic;
  bool quiet = false;
  std::vector<std::string> given{};  ///< names of all options given on the command line

  MemoryLimit memory() const { return max_memory ? *max_memory : usual_memory_limit(); }
};

void add_run_options(CLI::App& app, RunOptions& options);

/// Writes the warnings unless the run is quiet. `place` precedes warnings that name no file.
void report_warnings(const RunReport& report, const std::string& place, const RunOptions& options);

/// The files of a picture as named on the command line.
struct PictureNames {
  std::string output;
  std::string preview;  ///< may be empty
  std::string place;    ///< precedes warnings that name no file
};

/// Writes a picture, its preview, and the requested reports on standard error.
void deliver(Picture picture, const PictureNames& names, const RunOptions& options, RunReport& report, RunFiles& files);

/// Ends a run: writes its counts and times as the options require, and moves all files into place.
void finish(const RunOptions& options, const RunReport& report, RunFiles& files);

}  // namespace ligne
