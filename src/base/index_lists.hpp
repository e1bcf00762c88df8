#pragma once
/// Many lists of indices in one array.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ligne {

/// Lists of indices: list i is values[begin[i], begin[i + 1]).
struct IndexLists {
  std::vector<std::uint32_t> begin{0}, values;

  IndexLists() = default;
  /// `count` lists, each in the order in which its values are added. Calls visit(add) twice; each time it must call
  /// add(list, value) for all values.
  template <class Visit>
  IndexLists(std::size_t count, const Visit& visit) : begin(count + 2, 0) {
    // Counts are stored two places further at first, so that filling moves each begin to its final value.
    visit([&](std::size_t list, std::uint32_t) { ++begin[list + 2]; });
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    values.resize(begin.back());
    visit([&](std::size_t list, std::uint32_t value) { values[begin[list + 1]++] = value; });
    begin.pop_back();
  }

  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {values.data() + begin[i], values.data() + begin[i + 1]};
  }
};

}  // namespace ligne
