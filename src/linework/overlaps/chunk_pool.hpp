#pragma once
/// Many growing lists in one store. A list is a chain of chunks, each about as large as all chunks before it, so that a
/// walk over the list is fast. Nothing moves when a list grows, so the store takes little more memory than its items.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/uninitialized_vector.hpp"

namespace ligne {

template <class T>
class ChunkPool {
 public:
  /// One of the lists; its items are in no order.
  struct List {
    std::uint32_t last = kNoChunk;  ///< its newest chunk
    std::uint32_t size = 0;
    std::uint32_t free = 0;  ///< unused places in the newest chunk
  };

  void push(List& list, const T& item) {
    if (list.free == 0) grow(list);
    const Chunk& chunk = chunks_[list.last];
    place(chunk)[chunk.size - list.free--] = item;
    ++list.size;
  }

  /// Calls visit(item) for each item until it returns true. Returns whether it did.
  template <class Visit>
  bool visit(const List& list, const Visit& visit) const {
    std::uint32_t unused = list.free;
    for (std::uint32_t c = list.last; c != kNoChunk; c = chunks_[c].before) {
      const T* const items = place(chunks_[c]);
      for (std::uint32_t i = 0; i < chunks_[c].size - unused; ++i) {
        if (visit(items[i])) return true;
      }
      unused = 0;
    }
    return false;
  }

  /// Returns all items and empties the list. Its chunks become free for other lists.
  std::vector<T> take(List& list) {
    std::vector<T> taken;
    taken.reserve(list.size);
    visit(list, [&](const T& item) { return taken.push_back(item), false; });
    for (std::uint32_t c = list.last; c != kNoChunk;) {
      std::uint32_t& unused = unused_[std::countr_zero(chunks_[c].size)];
      c = std::exchange(chunks_[c].before, std::exchange(unused, c));
    }
    list = {};
    return taken;
  }

 private:
  static constexpr std::uint32_t kNoChunk = ~std::uint32_t{0};
  static constexpr std::uint32_t kLargestOrder = 6, kBlock = 1u << 14;  // adjustable

  struct Chunk {
    std::uint32_t begin;   ///< index of its first place, counted over all blocks
    std::uint32_t before;  ///< the next older chunk of its list, or the next free chunk
    std::uint32_t size;    ///< a power of two
  };

  T* place(const Chunk& chunk) { return blocks_[chunk.begin / kBlock].data() + chunk.begin % kBlock; }
  const T* place(const Chunk& chunk) const { return blocks_[chunk.begin / kBlock].data() + chunk.begin % kBlock; }

  /// Adds a chunk about as large as all chunks that the list has.
  void grow(List& list) {
    const std::uint32_t order = std::min(kLargestOrder, static_cast<std::uint32_t>(std::bit_width(list.size)));
    std::uint32_t chunk = unused_[order];
    if (chunk != kNoChunk) {
      unused_[order] = chunks_[chunk].before;
    } else {
      const std::uint32_t size = 1u << order;
      if (end_ % kBlock + size > kBlock || end_ == blocks_.size() * kBlock) {
        end_ = static_cast<std::uint32_t>(blocks_.size()) * kBlock;
        blocks_.emplace_back(kBlock);
      }
      chunk = static_cast<std::uint32_t>(chunks_.size());
      chunks_.push_back({end_, kNoChunk, size});
      end_ += size;
    }
    chunks_[chunk].before = list.last;
    list.last = chunk;
    list.free = chunks_[chunk].size;
  }

  std::vector<UninitializedVector<T>> blocks_;
  std::vector<Chunk> chunks_;
  std::uint32_t end_ = 0;  ///< first place that belongs to no chunk
  std::array<std::uint32_t, kLargestOrder + 1> unused_ = none();

  static constexpr std::array<std::uint32_t, kLargestOrder + 1> none() {
    std::array<std::uint32_t, kLargestOrder + 1> all{};
    all.fill(kNoChunk);
    return all;
  }
};

}  // namespace ligne
