#pragma once
/// A progress bar on standard error.

#include <chrono>
#include <functional>

#include "cli/options/run_options.hpp"

namespace ligne {

/// Draws "[#####     ] 50%" in place and erases it at the end. `automatic` shows it only on a terminal, and only if the work
/// takes longer than half a second.
class ProgressBar {
 public:
  explicit ProgressBar(const RunOptions& options);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// A callback that shows the completed fraction in [0, 1] and erases the bar at 1. One thread at a time may call it. Empty
  /// if the bar is not shown.
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
