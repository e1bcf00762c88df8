#pragma once
/// What a run reports: times of its stages, the method's own figures, and warnings.

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "drawing/statistics.hpp"
#include "files/input_file.hpp"

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

/// What a picture lacks, or what was mended on the way to it.
struct RunWarning {
  std::string place;  ///< file that it is about; empty: the picture
  std::string text;   ///< a phrase
};

struct RunReport {
  std::string method;
  Statistics study;   ///< the method's own counts and times
  Statistics clear;   ///< what clear lines leave out or change, by cause; empty for exact ones
  Statistics stages;  ///< times of the whole run
  std::vector<RunWarning> warnings;
  InputFiles files;  ///< that were read on the way

  void warn(std::string text) { warnings.push_back({{}, std::move(text)}); }
};

/// As a table for people.
std::string report_text(const RunReport& report);

/// As JSON: {"format": "ligne-stats", "version": 1, "method", "counts", "seconds", "clear", "stages"}; "clear" only
/// where clear lines differ.
std::string report_json(const RunReport& report);

}  // namespace ligne
