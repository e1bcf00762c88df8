#pragma once
/// Disjoint sets: union-find with path halving (Tarjan and van Leeuwen, Worst-case analysis of set union algorithms,
/// 1984).

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace ligne {

/// A partition of the indices [0, n).
class DisjointSets {
 public:
  /// Puts each index into a set of its own.
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  /// The representative of the set that contains i: its lowest member.
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// Merges the sets that contain a and b.
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace ligne
