#pragma once
/// Messages and a progress bar on standard error.

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "scene/model/diagnostics.hpp"

namespace ligne {

struct RunOptions;

/// Writes "ligne: TEXT" as one line of bounded length, whatever the text contains.
void say(std::string_view text);

/// Writes "ligne: PLACE: warning: TEXT".
void warn(const std::string& place, const std::string& text);

/// Warns of faults repaired while reading, one line per kind with its count; `with_areas` as in Warnings::lines().
void warn(const std::string& place, const Warnings& warnings, bool with_areas = true);

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
