#pragma once
/// Runs of equal keys in an order where equal keys stand together.

#include <cstddef>

#include "geometry/parallel.hpp"

namespace ligne {

/// Things in a block of for_each_run().
inline constexpr std::size_t kRunBlock = 16'384;

/// Calls visit(begin, end) for the runs of things with equal keys among those of numbers [0, n), in parallel: a run
/// belongs to the block of kRunBlock things in which it begins.
template <class Key, class Visit>
void for_each_run(std::size_t n, Key key, Visit visit) {
  parallel_blocks(n, kRunBlock, [&](std::size_t first, std::size_t last) {
    std::size_t begin = first;
    while (begin > 0 && begin < last && key(begin) == key(begin - 1)) ++begin;  // the run of the block before
    while (begin < last) {
      std::size_t end = begin + 1;
      while (end < n && key(end) == key(begin)) ++end;
      if (end - begin > 1) visit(begin, end);
      begin = end;
    }
  });
}

}  // namespace ligne
