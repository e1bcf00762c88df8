#pragma once
/// A progress bar on standard error.

#include <chrono>
#include <functional>

#include "cli/options/run_options.hpp"

namespace ligne {

/// Draws "[#####     ] 50%" over itself and wipes it when it goes. `automatic` shows it on a terminal only, and only when
/// the work takes longer than half a second.
class ProgressBar {
 public:
  explicit ProgressBar(const RunOptions& options);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// A callback that shows the fraction done, in [0, 1], and wipes the bar at 1; to be called from one thread at a time.
  /// Empty where there is nobody to show it to.
  std::function<void(double)> callback();

 private:
  void update(double fraction);
  void wipe();

  bool wanted_ = false;
  bool drawn_ = false;
  int percent_ = -1;
  std::chrono::steady_clock::time_point show_from_;
};

}  // namespace ligne
