#pragma once
/// A progress bar on standard error.

#include <chrono>

#include "cli/run_options.hpp"

namespace ligne {

/// Draws "[#####     ] 50%" over itself and wipes it when it goes. `automatic` shows it on a terminal only, and only when
/// the work takes longer than half a second.
class ProgressBar {
 public:
  explicit ProgressBar(const RunOptions& options);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Whether there is anybody to show it to.
  bool wanted() const { return wanted_; }
  /// To be called from one thread at a time, fraction in [0, 1].
  void update(double fraction);

 private:
  bool wanted_ = false;
  bool drawn_ = false;
  int percent_ = -1;
  std::chrono::steady_clock::time_point show_from_;
};

}  // namespace ligne
