#pragma once
/// Parallel selection of indices.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {

/// The indices i of [0, count) for which wanted(i) is true, ascending. Several threads call wanted().
template <class Wanted>
std::vector<std::uint32_t> indices_where(std::size_t count, const Wanted& wanted) {
  std::vector<std::vector<std::uint32_t>> found(block_count(count, kShortWorkBlock));
  parallel_blocks(count, kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (wanted(i)) found[begin / kShortWorkBlock].push_back(static_cast<std::uint32_t>(i));
    }
  });
  std::size_t size = 0;
  for (const std::vector<std::uint32_t>& block : found) size += block.size();
  std::vector<std::uint32_t> all;
  all.reserve(size);
  for (const std::vector<std::uint32_t>& block : found) all.insert(all.end(), block.begin(), block.end());
  return all;
}

}  // namespace ligne
