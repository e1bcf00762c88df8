#pragma once
/// Options that say how the program behaves while it works.

#include <functional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace ligne {

enum class ShowProgress { automatic, always, never };
inline constexpr std::string_view kShowProgressNames[] = {"auto", "always", "never"};

struct RunOptions {
  unsigned threads = 0;  ///< 0: all cores
  bool stats = false;
  std::string stats_json;  ///< file, or empty
  ShowProgress progress = ShowProgress::automatic;
  bool quiet = false;
};

void add_run_options(CLI::App& app, RunOptions& options);

/// Calls `work` with the number of threads asked for.
void run_with_threads(const RunOptions& options, const std::function<void()>& work);

}  // namespace ligne
