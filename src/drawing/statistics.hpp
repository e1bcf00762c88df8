#pragma once
/// Named counts and times of a run, in the order in which they were added.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ligne {

struct Statistics {
  std::vector<std::pair<std::string, std::uint64_t>> counts;
  std::vector<std::pair<std::string, double>> seconds;

  // Not inline: the code that makes a string is long, and a method adds dozens of entries.
  void count(std::string_view name, std::uint64_t n);
  void time(std::string_view name, double s);
};

}  // namespace ligne
