#pragma once
/// Reads numbers from binary data.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

namespace ligne {

/// The number of type T stored at p in the given byte order.
template <typename T>
T load_bytes(const std::byte* p, std::endian order) {
  std::array<std::byte, sizeof(T)> raw;
  std::memcpy(raw.data(), p, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

enum class NumberType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

constexpr std::size_t byte_size(NumberType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}
constexpr bool is_float(NumberType type) { return type >= NumberType::float32; }

enum class NumberKind : std::uint8_t { signed_integer, unsigned_integer, floating };

/// The type of a kind with so many bytes; nothing if there is none.
constexpr std::optional<NumberType> number_type(NumberKind kind, std::size_t bytes) {
  for (std::uint8_t i = 0; i <= static_cast<std::uint8_t>(NumberType::float64); ++i) {
    const auto type = static_cast<NumberType>(i);
    const NumberKind own = is_float(type) ? NumberKind::floating : static_cast<NumberKind>(i % 2);
    if (own == kind && byte_size(type) == bytes) return type;
  }
  return {};
}

template <typename T>
double load_as_double(const std::byte* p, std::endian order) {
  return static_cast<double>(load_bytes<T>(p, order));
}

/// The number of this type stored at p.
inline double load_number(const std::byte* p, NumberType type, std::endian order) {
  constexpr double (*kLoad[])(const std::byte*, std::endian) = {load_as_double<std::int8_t>,  load_as_double<std::uint8_t>,
                                                                load_as_double<std::int16_t>, load_as_double<std::uint16_t>,
                                                                load_as_double<std::int32_t>, load_as_double<std::uint32_t>,
                                                                load_as_double<std::int64_t>, load_as_double<std::uint64_t>,
                                                                load_as_double<float>,        load_as_double<double>};
  return kLoad[static_cast<std::size_t>(type)](p, order);
}

}  // namespace ligne
