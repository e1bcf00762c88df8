#pragma once
/// Finds runs of equal keys in a list in which equal keys are adjacent.

#include <cstddef>

#include "base/parallel.hpp"

namespace ligne {

/// Number of items per block of for_each_run().
inline constexpr std::size_t kRunBlock = 16'384;

/// Calls visit(begin, end) in parallel for each run of at least two items of [0, n) with equal keys; key(i) is the key
/// of item i. A run is visited by the task of the block in which it begins.
template <class Key, class Visit>
void for_each_run(std::size_t n, Key key, Visit visit) {
  parallel_blocks(n, kRunBlock, [&](std::size_t first, std::size_t last) {
    std::size_t begin = first;
    auto of_run = key(begin);
    if (begin > 0 && key(begin - 1) == of_run) {  // the run belongs to the previous block
      while (begin < last && key(begin) == of_run) ++begin;
      if (begin < last) of_run = key(begin);
    }
    while (begin < last) {
      std::size_t end = begin + 1;
      auto next = of_run;
      while (end < n && (next = key(end)) == of_run) ++end;
      if (end - begin > 1) visit(begin, end);
      begin = end;
      of_run = next;
    }
  });
}

}  // namespace ligne
