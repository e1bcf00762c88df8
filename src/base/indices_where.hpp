#pragma once
/// Parallel selection of indices.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {

/// Calls append(begin, end, found) for blocks of `size` indices of [0, count), and returns the indices that it adds to
/// `found`, in the order of the blocks. Several threads call append().
template <class Append>
std::vector<std::uint32_t> indices_of_blocks(std::size_t count, const Append& append, std::size_t size = kShortWorkBlock) {
  std::vector<std::vector<std::uint32_t>> found(block_count(count, size));
  parallel_blocks(count, size, [&](std::size_t begin, std::size_t end) { append(begin, end, found[begin / size]); });
  std::size_t total = 0;
  for (const std::vector<std::uint32_t>& block : found) total += block.size();
  std::vector<std::uint32_t> all;
  all.reserve(total);
  for (const std::vector<std::uint32_t>& block : found) all.insert(all.end(), block.begin(), block.end());
  return all;
}

/// The indices i of [0, count) for which wanted(i) is true, ascending. Several threads call wanted(). `size`: see
/// indices_of_blocks().
template <class Wanted>
std::vector<std::uint32_t> indices_where(std::size_t count, const Wanted& wanted, std::size_t size = kShortWorkBlock) {
  const auto append = [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& found) {
    for (std::size_t i = begin; i < end; ++i) {
      if (wanted(i)) found.push_back(static_cast<std::uint32_t>(i));
    }
  };
  return indices_of_blocks(count, append, size);
}

/// The indices of the elements that have any of the bits `wanted`, ascending. `marks` is an array of unsigned integers.
/// Four 64-bit words without these bits are skipped at once, so rare marks cost little.
template <class Marks>
std::vector<std::uint32_t> indices_of_marks(const Marks& marks, std::uint64_t wanted = ~std::uint64_t{0}) {
  const auto* const values = std::data(marks);
  constexpr std::size_t kSize = sizeof *values, kInWord = sizeof(std::uint64_t) / kSize;
  std::uint64_t wanted_of_word = 0;
  for (std::size_t k = 0; k < kInWord; ++k) wanted_of_word |= wanted << (8 * kSize * k);
  constexpr std::size_t kWords = 4, kInRun = kWords * kInWord;
  const auto is_wanted_in_run = [&](std::size_t i) {
    std::array<std::uint64_t, kWords> words;
    std::memcpy(words.data(), values + i, sizeof words);
    return ((words[0] | words[1] | words[2] | words[3]) & wanted_of_word) != 0;
  };
  return indices_of_blocks(std::size(marks), [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& found) {
    for (std::size_t i = begin; i < end;) {
      const std::size_t last = std::min(i + kInRun, end);
      if (last - i == kInRun && !is_wanted_in_run(i)) {
        i = last;
        continue;
      }
      for (; i < last; ++i) {
        if (static_cast<std::uint64_t>(values[i]) & wanted) found.push_back(static_cast<std::uint32_t>(i));
      }
    }
  });
}

}  // namespace ligne
