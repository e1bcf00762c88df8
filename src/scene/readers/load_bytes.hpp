#pragma once
/// Reads numbers from binary data.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace ligne {

/// The number of type T stored at p in the given byte order.
template <typename T>
T load_bytes(const std::byte* p, std::endian order) {
  std::array<std::byte, sizeof(T)> raw;
  std::memcpy(raw.data(), p, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

}  // namespace ligne
