#pragma once
/// The report of a run: times of its stages, statistics of the method, and warnings.

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

/// Times of the stages of a run: elapsed time (Statistics::seconds) and processor time, which is the sum over all
/// threads and does not include other programs.
struct StageTimes : Statistics {
  std::vector<std::pair<std::string, double>> processor_seconds;
};

/// Calls work() and adds its times under the name of the stage. If it runs out of memory (std::bad_alloc, or
/// std::length_error from a size beyond the address space), throws a MemoryError that names the stage.
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

/// A warning: a fault of the picture, or a fault of the input that was repaired.
struct RunWarning {
  std::string place;  ///< file that it concerns; empty: the picture
  std::string text;   ///< phrase without a full stop
};

struct RunReport {
  std::string method;
  Statistics study;   ///< counts and times of the method
  Statistics clear;   ///< numbers of lines that clear lines remove or change, by cause; empty for exact lines
  StageTimes stages;  ///< times of all stages of the run
  /// Automatic choices: the name of the choice ("method"), and a phrase with its result and reason.
  std::vector<std::pair<std::string, std::string>> choices;
  std::vector<RunWarning> warnings;
  InputFiles files;  ///< files that were read

  /// Counts changes of clear lines, if there are any.
  void count_clear(std::string_view cause, std::uint64_t n) {
    if (n > 0) clear.count(cause, n);
  }
  void warn(std::string text) { warnings.push_back({{}, std::move(text)}); }
};

/// The report as a table for people.
std::string report_text(const RunReport& report);

}  // namespace ligne
