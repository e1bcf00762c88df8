#pragma once
/// Many lists in one array.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ligne {

/// List i is values[begin[i], begin[i + 1]).
template <class Item>
struct ListsOf {
  std::vector<std::uint32_t> begin{0};
  std::vector<Item> values{};

  ListsOf() = default;
  /// `count` lists by a counting sort, each in the order in which its values are added. Calls visit(add) twice; each time
  /// it must call add(list, value) for all values. O(count + values).
  template <class Visit>
  ListsOf(std::size_t count, const Visit& visit) : begin(count + 2, 0) {
    // Counts are stored two places further at first, so that filling moves each begin to its final value.
    visit([&](std::size_t list, const Item&) { ++begin[list + 2]; });
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    values.resize(begin.back());
    visit([&](std::size_t list, const Item& value) { values[begin[list + 1]++] = value; });
    begin.pop_back();
  }

  std::size_t size() const { return begin.size() - 1; }
  std::span<const Item> operator[](std::size_t i) const { return {values.data() + begin[i], values.data() + begin[i + 1]}; }
  std::span<Item> operator[](std::size_t i) { return {values.data() + begin[i], values.data() + begin[i + 1]}; }
};

using IndexLists = ListsOf<std::uint32_t>;

/// The numbers i of [0, count) by key(i) < keys.
template <class Key>
IndexLists numbers_by_key(std::size_t keys, std::size_t count, const Key& key) {
  return {keys, [&](const auto& add) {
            for (std::uint32_t i = 0; i < count; ++i) add(key(i), i);
          }};
}

}  // namespace ligne
