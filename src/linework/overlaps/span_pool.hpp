#pragma once
/// Many growing lists in one array. The items of a list are adjacent, so that a walk over the list is fast.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ligne {

/// The array. A list that is full moves to a place of twice its size, and another list may take its old place.
template <class T>
class SpanPool {
 public:
  /// One of the lists; its items are in no order.
  struct List {
    std::uint32_t begin = 0, size = 0, capacity = 0;  ///< capacity: 0 or a power of two
  };

  std::span<const T> items(const List& list) const { return {items_.data() + list.begin, list.size}; }

  void push(List& list, const T& item) {
    if (list.size == list.capacity) grow(list);
    items_[list.begin + list.size++] = item;
  }

  /// Removes item number i. The last item takes its place.
  void remove(List& list, std::uint32_t i) { items_[list.begin + i] = items_[list.begin + --list.size]; }

 private:
  void release(const List& list) {
    if (list.capacity > 0) free_[order(list.capacity)].push_back(list.begin);
  }
  static std::size_t order(std::uint32_t capacity) { return static_cast<std::size_t>(std::countr_zero(capacity)); }

  void grow(List& list) {
    List wider{static_cast<std::uint32_t>(items_.size()), list.size, list.capacity == 0 ? 1 : 2 * list.capacity};
    if (std::vector<std::uint32_t>& unused = free_[order(wider.capacity)]; !unused.empty()) {
      wider.begin = unused.back();
      unused.pop_back();
    } else {
      items_.resize(items_.size() + wider.capacity);
    }
    std::copy_n(items_.begin() + list.begin, list.size, items_.begin() + wider.begin);
    release(list);
    list = wider;
  }

  std::vector<T> items_;
  std::array<std::vector<std::uint32_t>, 32> free_;  ///< free places, by the binary logarithm of their size
};

}  // namespace ligne
