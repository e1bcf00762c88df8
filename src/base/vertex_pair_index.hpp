#pragma once
/// Groups items by the pair of nodes that they join, such as sides of faces by their two vertices.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.hpp"

namespace ligne {

/// A counting sort puts the items into one bucket per lower node. In a mesh a bucket holds few items, so each is then
/// sorted in place by the higher node. O(n + items) for n nodes, if buckets are small.
class VertexPairIndex {
 public:
  struct Entry {
    std::uint32_t high;  ///< the higher of the two nodes
    std::uint32_t item;  ///< the caller's number of the item
  };

  /// list(add) must call add(a, b, item) for every item that joins the nodes a and b in [0, nodes), in ascending order of
  /// `item`. Several threads call it several times, and it must list the same items each time. `about`: approximate
  /// number of items.
  template <class List>
  VertexPairIndex(std::size_t nodes, std::size_t about, const List& list) : begin_(nodes + 1, 0) {
    // A task owns a range of nodes and lists all items, so the entries of a bucket keep the order of the items for any
    // number of ranges.
    constexpr std::size_t kItemsPerRange = 50'000, kMostRanges = 4;
    const std::size_t ranges = std::clamp<std::size_t>(about / kItemsPerRange, 1, std::min(kMostRanges, thread_count()));
    const auto for_range = [&](std::size_t r, auto visit) {
      const auto first = static_cast<std::uint32_t>(nodes * r / ranges);
      const auto count = static_cast<std::uint32_t>(nodes * (r + 1) / ranges) - first;
      list([&](std::uint32_t a, std::uint32_t b, std::uint32_t item) {
        const std::uint32_t low = std::min(a, b);
        if (low - first < count) visit(low, std::max(a, b), item);
      });
    };
    parallel_for(ranges, [&](std::size_t r) {
      for_range(r, [&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++begin_[low + 1]; });
    });
    for (std::size_t v = 0; v < nodes; ++v) begin_[v + 1] += begin_[v];
    entries_.resize(begin_[nodes]);
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    parallel_for(ranges, [&](std::size_t r) {
      for_range(r, [&](std::uint32_t low, std::uint32_t high, std::uint32_t item) { entries_[next[low]++] = {high, item}; });
    });
    parallel_blocks(nodes, kShortWorkBlock, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) sort(entries_.data() + begin_[v], entries_.data() + begin_[v + 1]);
    });
  }

  /// Calls visit(low, entries) for each pair of nodes that some item joins and whose lower node is in [first, last), in
  /// ascending order of the pairs. `entries` are the items of the pair, ascending.
  template <class Visit>
  void for_each_pair(std::size_t first, std::size_t last, const Visit& visit) const {
    for (std::size_t low = first; low < last; ++low) {
      for (std::uint32_t k = begin_[low]; k < begin_[low + 1];) {
        std::uint32_t end = k + 1;
        while (end < begin_[low + 1] && entries_[end].high == entries_[k].high) ++end;
        visit(static_cast<std::uint32_t>(low), std::span(entries_).subspan(k, end - k));
        k = end;
      }
    }
  }

 private:
  /// Sorts a bucket by the higher node. The sort is stable.
  static void sort(Entry* begin, Entry* end) {
    constexpr std::ptrdiff_t kInsertionSortLimit = 32;
    if (end - begin > kInsertionSortLimit) {  // the hub of a large fan
      std::stable_sort(begin, end, [](const Entry& a, const Entry& b) { return a.high < b.high; });
      return;
    }
    for (Entry* i = begin == end ? end : begin + 1; i < end; ++i) {
      const Entry moved = *i;
      Entry* to = i;
      for (; to > begin && moved.high < to[-1].high; --to) *to = to[-1];
      *to = moved;
    }
  }

  std::vector<std::uint32_t> begin_;  ///< per lower node: its first entry; then the number of entries
  std::vector<Entry> entries_;
};

}  // namespace ligne
