#pragma once
/// Parallel loops over single indices.

#include <cstddef>

#include "base/parallel.hpp"

namespace ligne {

/// Calls work(i) for all i in [0, count), in parallel: one task for each block of `size` indices.
template <class Work>
void parallel_each(std::size_t count, const Work& work, std::size_t size = kShortWorkBlock) {
  parallel_blocks(count, size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) work(i);
  });
}

}  // namespace ligne
