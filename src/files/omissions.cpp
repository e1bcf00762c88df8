#include "files/omissions.hpp"

#include <algorithm>

#include "files/message_text.hpp"

namespace ligne {
namespace {

/// Largest number of kinds that are counted separately: files of unknown words can have a million.
constexpr std::size_t kMostKinds = 16;
/// Largest length of a kind in bytes: a line has room for most of them.
constexpr std::size_t kLongestKind = 60;
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
  std::string text;
  for (const auto& [kind, n] : counts_) text += (text.empty() ? "" : ", ") + counted(n, kind);
  return text;
}

std::string Omissions::text() const { return empty() ? "" : "left out: " + list(); }

}  // namespace ligne
