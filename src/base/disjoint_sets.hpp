#pragma once
/// Sets of things that hang together: union-find with path halving (Tarjan and van Leeuwen, Worst-case analysis of set union
/// algorithms, 1984).

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace ligne {

class DisjointSets {
 public:
  /// Each of [0, n) is a set of its own.
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  /// The member that stands for the set of i: its lowest one.
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace ligne
