#pragma once
/// The report of a run: times of its stages, the method's own figures, and warnings.

#include <chrono>
#include <ctime>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "drawing/statistics.hpp"
#include "files/input_file.hpp"
#include "picture/models/memory.hpp"

namespace ligne {

/// Times of a run's stages, on the clock and of the processor: of all threads together, and without what other programs
/// take.
struct StageTimes : Statistics {
  std::vector<std::pair<std::string, double>> processor_seconds;
};

/// Calls the work and, when it is done, adds its times under the stage's name. Work that finds no memory ends in a
/// MemoryError that names the stage; so does work that asks for more than there are addresses (std::length_error).
template <class Work>
auto timed(StageTimes& stages, const Stage& stage, Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processor_start = std::clock();
  const auto add_time = [&] {
    const auto processor = static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC;
    stages.processor_seconds.emplace_back(stage.name, processor);
    stages.time(stage.name, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  };
  try {
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      add_time();
    } else {
      auto result = work();
      add_time();
      return result;
    }
  } catch (const MemoryError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw out_of_memory(stage);
  } catch (const std::length_error&) {
    throw out_of_memory(stage);
  }
}

/// A fault of a picture, or one that was mended on the way to it.
struct RunWarning {
  std::string place;  ///< file that it is about; empty: the picture
  std::string text;   ///< a phrase
};

struct RunReport {
  std::string method;
  Statistics study;   ///< the method's own counts and times
  Statistics clear;   ///< what clear lines leave out or change, by cause; empty for exact ones
  StageTimes stages;  ///< of the whole run
  /// The choices where nothing was said: a name and a phrase.
  std::vector<std::pair<std::string, std::string>> choices;
  std::vector<RunWarning> warnings;
  InputFiles files;  ///< that were read on the way

  void warn(std::string text) { warnings.push_back({{}, std::move(text)}); }
};

/// As a table for people.
std::string report_text(const RunReport& report);

/// As JSON: {"format": "ligne-stats", "version": 1, "method", "counts", "seconds", "clear", "choices", "stages",
/// "processor_seconds"}; "clear" only where clear lines differ, "choices" only where something was chosen.
std::string report_json(const RunReport& report);

}  // namespace ligne
