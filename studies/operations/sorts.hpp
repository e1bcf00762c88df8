#pragma once
/// The four sorts of [Boulle1980] 3.3 over any values, with counts of comparisons and moves: quick, bubble, tree, Shell. The
/// first two follow the pseudo-code there, with its slips corrected (the inner loops move i and j); the others follow
/// [Knuth1973].

#include <cstdint>
#include <utility>
#include <vector>

namespace ligne::studies {

struct SortCounts {
  std::uint64_t comparisons = 0;
  std::uint64_t moves = 0;    ///< moved elements; an exchange counts three
  std::uint64_t deepest = 0;  ///< largest depth of the quick sort's stack
};

template <class T>
void quick_sort(std::vector<T>& list, SortCounts& counts) {
  using Index = std::ptrdiff_t;
  std::vector<std::pair<Index, Index>> open{{0, Index(list.size()) - 1}};
  while (!open.empty()) {
    counts.deepest = counts.deepest < open.size() ? open.size() : counts.deepest;
    auto [l, r] = open.back();
    open.pop_back();
    while (l < r) {
      Index i = l, j = r;
      const T pivot = list[std::size_t((l + r) / 2)];
      while (i <= j) {
        while (++counts.comparisons, list[std::size_t(i)] < pivot) ++i;
        while (++counts.comparisons, pivot < list[std::size_t(j)]) --j;
        if (i <= j) {
          if (i < j) {
            std::swap(list[std::size_t(i)], list[std::size_t(j)]);
            counts.moves += 3;
          }
          ++i;
          --j;
        }
      }
      // The larger part is stacked and the smaller one sorted first, so the stack stays below log2 n.
      if (j - l < r - i) {
        if (i < r) open.emplace_back(i, r);
        r = j;
      } else {
        if (l < j) open.emplace_back(l, j);
        l = i;
      }
    }
  }
}

template <class T>
void bubble_sort(std::vector<T>& list, SortCounts& counts) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
      ++counts.comparisons;
      if (list[i + 1] < list[i]) {
        std::swap(list[i], list[i + 1]);
        counts.moves += 3;
        changed = true;
      }
    }
  }
}

/// Heap sort: in the tree every node is larger than its children.
template <class T>
void tree_sort(std::vector<T>& list, SortCounts& counts) {
  const auto sift = [&](std::size_t node, std::size_t end) {
    for (;;) {
      std::size_t child = 2 * node + 1;
      if (child >= end) return;
      if (child + 1 < end && (++counts.comparisons, list[child] < list[child + 1])) ++child;
      if (++counts.comparisons, !(list[node] < list[child])) return;
      std::swap(list[node], list[child]);
      counts.moves += 3;
      node = child;
    }
  };
  for (std::size_t node = list.size() / 2; node-- > 0;) sift(node, list.size());
  for (std::size_t end = list.size(); end-- > 1;) {
    std::swap(list[0], list[end]);
    counts.moves += 3;
    sift(0, end);
  }
}

/// Steps 1, 3, 7, 15, ..., which give O(n^(3/2)).
template <class T>
void shell_sort(std::vector<T>& list, SortCounts& counts) {
  std::size_t step = 1;
  while (2 * step + 1 < list.size()) step = 2 * step + 1;
  for (; step > 0; step /= 2) {
    for (std::size_t i = step; i < list.size(); ++i) {
      T item = std::move(list[i]);
      std::size_t k = i;
      while (k >= step && (++counts.comparisons, item < list[k - step])) {
        list[k] = std::move(list[k - step]);
        ++counts.moves;
        k -= step;
      }
      list[k] = std::move(item);
      counts.moves += 2;
    }
  }
}

}  // namespace ligne::studies
