#pragma once
/// Counting sort by parts, in parallel.

#include <cstddef>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {

/// Files things by parts. list(begin, end, take) calls take(part, thing...) for the things of the indices [begin, end) of
/// [0, count), the same each time it is called; allocate(n) makes room when it is known that there are n of them; and
/// put(place, thing...) writes one. Blocks of so many indices write one after the other into a part: so the things of a part
/// stand in the order in which they are listed, whatever the number of threads. Returns the first place of each part, and
/// the end. O(things + parts * blocks).
template <class List, class Allocate, class Put>
std::vector<std::size_t> parallel_counting_sort(std::size_t count, std::size_t block, std::size_t parts, const List& list,
                                                const Allocate& allocate, const Put& put) {
  const std::size_t blocks = block_count(count, block);
  std::vector<std::size_t> place(blocks * parts, 0);  // counts, then the next places, per block and part
  parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
    std::size_t* const counts = place.data() + begin / block * parts;
    list(begin, end, [counts](std::size_t part, const auto&...) { ++counts[part]; });
  });
  std::vector<std::size_t> first;
  first.reserve(parts + 1);
  std::size_t sum = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    first.push_back(sum);
    for (std::size_t b = 0; b < blocks; ++b) sum += std::exchange(place[b * parts + part], sum);
  }
  first.push_back(sum);
  allocate(sum);
  parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
    std::size_t* const next = place.data() + begin / block * parts;
    list(begin, end, [&put, next](std::size_t part, const auto&... thing) { put(next[part]++, thing...); });
  });
  return first;
}

}  // namespace ligne
