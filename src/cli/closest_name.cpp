#include "cli/closest_name.hpp"

#include <algorithm>
#include <vector>

namespace ligne {
namespace {

std::string_view without_dashes(std::string_view name) {
  return name.substr(std::min(name.find_first_not_of('-'), name.size()));
}

/// The number of slips that make one word of the other.
std::size_t slips_between(std::string_view a, std::string_view b) {
  // Rows of the table of the distances of all beginnings; neighbours exchanged reach two rows back.
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::optional<std::string> closest_name(std::string_view word, std::span<const std::string> names) {
  const std::string_view written = without_dashes(word.substr(0, word.find('=')));
  constexpr std::size_t kLongest = 64;  // no name is as long
  if (written.empty() || written.size() > kLongest) return std::nullopt;
  std::size_t most = written.size() <= 2 ? 0 : written.size() <= 5 ? 1 : 2;
  std::optional<std::string> closest;
  for (const std::string& name : names) {
    const std::size_t slips = slips_between(written, without_dashes(name));
    if (slips > most || (closest && slips == most && name.size() <= closest->size())) continue;
    closest = name;
    most = slips;
  }
  return closest;
}

}  // namespace ligne
