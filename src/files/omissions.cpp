#include "files/omissions.hpp"

#include <algorithm>
#include <numeric>

#include "files/message_text.hpp"

namespace ligne {
namespace {

/// Largest number of kinds that are counted separately: files of unknown words can have a million.
constexpr std::size_t kMostKinds = 16;
/// Largest length of a kind in bytes: a line has room for most of them.
constexpr std::size_t kLongestKind = 60;
/// Largest number of kinds that a list names. Longer lists tell nobody more.
constexpr std::size_t kMostListed = 6;
constexpr char kOtherKinds[] = "other items";

}  // namespace

void Omissions::count(std::string_view what, std::size_t n) {
  if (n == 0) return;
  std::string kind = printable(what, kLongestKind);
  const auto named = [&](const std::string& name) {
    return std::find_if(counts_.begin(), counts_.end(), [&](const auto& entry) { return entry.first == name; });
  };
  auto entry = named(kind);
  if (entry == counts_.end() && counts_.size() >= kMostKinds) {
    kind = kOtherKinds;
    entry = named(kind);
  }
  if (entry == counts_.end()) entry = counts_.insert(counts_.end(), {std::move(kind), 0});
  entry->second += n;
}

std::size_t Omissions::of(std::string_view what) const {
  for (const auto& [kind, n] : counts_) {
    if (kind == what) return n;
  }
  return 0;
}

std::string Omissions::list() const {
  std::vector<std::size_t> order(counts_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::size_t others = 0;
  if (order.size() > kMostListed) {
    // The least frequent kinds share one entry.
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return counts_[a].second > counts_[b].second; });
    for (std::size_t k = kMostListed - 1; k < order.size(); ++k) others += counts_[order[k]].second;
    order.resize(kMostListed - 1);
    std::ranges::sort(order);
  }
  std::string text;
  for (const std::size_t k : order) text += (text.empty() ? "" : ", ") + counted(counts_[k].second, counts_[k].first);
  return others == 0 ? text : text + " and " + std::to_string(others) + " others";
}

Omissions Omissions::of_lines() const {
  Omissions others = *this;
  std::erase_if(others.counts_, [](const auto& entry) { return entry.first.starts_with("textures"); });
  return others;
}

std::string Omissions::text() const { return empty() ? "" : "left out: " + list(); }

}  // namespace ligne
