#pragma once
/// Counts and times of a study, in the order in which they were added.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ligne {

struct Statistics {
  std::vector<std::pair<std::string, std::uint64_t>> counts;
  std::vector<std::pair<std::string, double>> seconds;

  // Not inline: what makes a text is long, and a study names dozens of figures.
  void count(std::string_view name, std::uint64_t n);
  void time(std::string_view name, double s);
};

}  // namespace ligne
