#pragma once
/// A flat hash table from 64-bit keys to 32-bit values: open addressing, linear probing, no removal.

#include <cstdint>
#include <utility>
#include <vector>

#include "base/hash.hpp"
#include "base/no_index.hpp"

namespace ligne {

/// Maps keys to values below kNone, which marks an empty slot.
class KeyTable {
 public:
  /// The key of a pair of coordinates.
  static std::uint64_t key(std::int32_t x, std::int32_t y) {
    return std::uint64_t(std::uint32_t(x)) << 32 | std::uint32_t(y);
  }
  static std::uint64_t key(const auto& lattice_point) { return key(lattice_point.x, lattice_point.y); }

  /// The value of the key, or kNone if the key is not in the table.
  std::uint32_t find(std::uint64_t key) const { return slots_[slot_of(key)].second; }

  /// A reference to the value of the key. It is kNone if the key is new; the caller must then assign a value before the
  /// next call.
  std::uint32_t& operator[](std::uint64_t key) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    auto& slot = slots_[slot_of(key)];
    if (slot.second == kNone) {
      slot.first = key;
      ++size_;
    }
    return slot.second;
  }

 private:
  std::size_t slot_of(std::uint64_t key) const {
    std::size_t slot = mix_bits(key) & (slots_.size() - 1);
    while (slots_[slot].second != kNone && slots_[slot].first != key) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }
  void grow() {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> old(2 * slots_.size(), {0, kNone});
    old.swap(slots_);
    for (const auto& slot : old) {
      if (slot.second != kNone) slots_[slot_of(slot.first)] = slot;
    }
  }

  std::vector<std::pair<std::uint64_t, std::uint32_t>> slots_{16, {0, kNone}};
  std::size_t size_ = 0;
};

}  // namespace ligne
