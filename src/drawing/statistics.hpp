#pragma once
/// Counts and times of a study, in the order in which they were added.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ligne {

struct Statistics {
  std::vector<std::pair<std::string, std::uint64_t>> counts;
  std::vector<std::pair<std::string, double>> seconds;

  void count(std::string name, std::uint64_t n) { counts.emplace_back(std::move(name), n); }
  void time(std::string name, double s) { seconds.emplace_back(std::move(name), s); }
};

}  // namespace ligne
