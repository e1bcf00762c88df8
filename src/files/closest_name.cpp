#include "files/closest_name.hpp"

#include <algorithm>
#include <vector>

namespace ligne {
namespace {

std::string_view without_dashes(std::string_view name) {
  return name.substr(std::min(name.find_first_not_of('-'), name.size()));
}

/// Number of typing slips that turn one word into the other.
std::size_t slips_between(std::string_view a, std::string_view b) {
  // Rows of the table of distances of all prefixes. Exchanged neighbours need the row before the last.
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

/// The longest name with which the word begins; otherwise the first name that begins with the word.
std::optional<std::string_view> longer_or_shorter(std::string_view written, std::span<const std::string_view> names) {
  constexpr std::size_t kLeast = 3;  // letters; fewer begin too many words
  std::optional<std::string_view> closest;
  for (const std::string_view name : names) {
    const std::string_view bare = without_dashes(name);
    if (bare.size() < kLeast || !written.starts_with(bare)) continue;
    if (!closest || bare.size() > without_dashes(*closest).size()) closest = name;
  }
  if (closest || written.size() < kLeast) return closest;
  const auto begins = [&](std::string_view name) { return without_dashes(name).starts_with(written); };
  const auto found = std::ranges::find_if(names, begins);
  return found == names.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

std::optional<std::string_view> closest_name(std::string_view word, std::span<const std::string_view> names) {
  const std::string_view written = without_dashes(word.substr(0, word.find('=')));
  constexpr std::size_t kLongest = 64;  // no name is this long
  if (written.empty() || written.size() > kLongest) return std::nullopt;
  std::size_t most = written.size() <= 2 ? 0 : written.size() <= 5 ? 1 : 2;
  std::optional<std::string_view> closest;
  for (const std::string_view name : names) {
    const std::size_t slips = slips_between(written, without_dashes(name));
    if (slips > most || (closest && slips == most && name.size() <= closest->size())) continue;
    closest = name;
    most = slips;
  }
  return closest ? closest : longer_or_shorter(written, names);
}

std::string suggestion(std::string_view word, std::span<const std::string_view> names) {
  const auto meant = closest_name(word, names);
  return meant ? " (" + std::string(*meant) + "?)" : "";
}

}  // namespace ligne
