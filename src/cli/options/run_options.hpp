#pragma once
/// Options that say how the program behaves while it works.

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
  std::string stats_json;  ///< file, or empty
  ShowProgress progress = ShowProgress::automatic;
  bool quiet = false;
  std::vector<std::string> given{};  ///< names of all options that the command line gives

  MemoryLimit memory() const { return max_memory ? *max_memory : usual_memory_limit(); }
};

void add_run_options(CLI::App& app, RunOptions& options);

/// Writes the warnings, but not those of a quiet run. `place` stands at the head of warnings that name no file.
void report_warnings(const RunReport& report, const std::string& place, const RunOptions& options);

/// The files of a picture as the command line names them.
struct PictureNames {
  std::string output;
  std::string preview;  ///< may be empty
  std::string place;    ///< at the head of warnings, as above
};

/// Hands over a picture: its file, the preview beside it, and what was asked for on standard error.
void deliver(Picture picture, const PictureNames& names, const RunOptions& options, RunReport& report, RunFiles& files);

/// The end of a run: writes its counts and times where the options want them, and puts all files in their places.
void finish(const RunOptions& options, const RunReport& report, RunFiles& files);

}  // namespace ligne
