#pragma once
/// Lists of things at the vertices of an object.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ligne {

/// A list of numbers per vertex, in the order in which they were added.
class AtVertices {
 public:
  /// Calls list(add) twice; each time `list` must call add(vertex, thing) for everything.
  template <class List>
  AtVertices(std::uint32_t vertex_begin, std::uint32_t vertex_end, const List& list)
      : vertex_begin_(vertex_begin), begin_(vertex_end - vertex_begin + 2, 0) {
    list([&](std::uint32_t vertex, std::uint32_t) { ++begin_[vertex - vertex_begin_ + 2]; });
    for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    things_.resize(begin_.back());
    list([&](std::uint32_t vertex, std::uint32_t thing) { things_[begin_[vertex - vertex_begin_ + 1]++] = thing; });
  }
  AtVertices() = default;

  std::span<const std::uint32_t> operator[](std::uint32_t vertex) const {
    const std::uint32_t v = vertex - vertex_begin_;
    return {things_.data() + begin_[v], things_.data() + begin_[v + 1]};
  }

 private:
  std::uint32_t vertex_begin_ = 0;
  std::vector<std::uint32_t> begin_, things_;
};

}  // namespace ligne
