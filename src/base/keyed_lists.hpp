#pragma once
/// Lists by number, all in one array.

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace ligne {

/// Made by a counting sort: items of one list keep their order.
template <class Item>
class KeyedLists {
 public:
  KeyedLists() = default;
  /// `list(put)` calls put(number, item) for each item; it is called twice, and must list the same items. O(count + items).
  template <class List>
  KeyedLists(std::size_t count, const List& list) : begin_(count + 1, 0) {
    list([this](std::size_t number, const Item&) { ++begin_[number + 1]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    items_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    list([&](std::size_t number, const Item& item) { items_[next[number]++] = item; });
  }

  std::size_t size() const { return begin_.size() - 1; }
  std::span<const Item> operator[](std::size_t number) const {
    return {items_.data() + begin_[number], items_.data() + begin_[number + 1]};
  }
  std::span<Item> operator[](std::size_t number) {
    return {items_.data() + begin_[number], items_.data() + begin_[number + 1]};
  }

 private:
  std::vector<std::uint32_t> begin_{0};
  std::vector<Item> items_;
};

/// The numbers i of [0, count) by key(i) < keys.
template <class Key>
KeyedLists<std::uint32_t> numbers_by_key(std::size_t keys, std::size_t count, const Key& key) {
  return {keys, [&](const auto& put) {
            for (std::uint32_t i = 0; i < count; ++i) put(key(i), i);
          }};
}

}  // namespace ligne
