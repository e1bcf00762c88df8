#pragma once
/// A parallel, stable counting sort. The code calls a bucket a part.

#include <cstddef>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {

/// Sorts items into `parts` buckets. An index of [0, count) may produce any number of items. The caller passes three
/// functions:
/// - list(begin, end, take) calls take(part, item...) for all items of the indices [begin, end). Each of the two passes
///   calls it once per block of `block` indices. It must produce the same items both times;
/// - allocate(n) is called once, between the passes, with the total number of items;
/// - put(place, item...) stores an item at its place in [0, n). Several threads call it.
///
/// Items of a bucket keep the order in which they are listed, for any number of threads. Returns the first place of each
/// bucket, followed by n. Takes O(items + parts * blocks).
template <class List, class Allocate, class Put>
std::vector<std::size_t> parallel_counting_sort(std::size_t count, std::size_t block, std::size_t parts, const List& list,
                                                const Allocate& allocate, const Put& put) {
  const std::size_t blocks = block_count(count, block);
  std::vector<std::size_t> place(blocks * parts, 0);  // per block and part: its count, then its next place
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
