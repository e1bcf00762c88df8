// Appendix B of EXT_meshopt_compression. Streams may contain values that no encoder writes. Every quotient and every
// rounding is kept in range, so that such values are merely wrong.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "scene/readers/gltf/meshopt_codec.hpp"

namespace ligne {
namespace {

template <class T>
T rounded_to(float value) {
  constexpr auto most = static_cast<float>(std::numeric_limits<T>::max());
  return static_cast<T>(std::round(std::clamp(value, -1.0f, 1.0f) * most));
}

/// Applies `change` to runs of N numbers.
template <class T, std::size_t N, class Change>
void for_each_run(std::span<std::byte> bytes, const Change& change) {
  std::array<T, N> run;
  for (std::size_t at = 0; at + sizeof run <= bytes.size(); at += sizeof run) {
    std::memcpy(run.data(), bytes.data() + at, sizeof run);
    change(run);
    std::memcpy(bytes.data() + at, run.data(), sizeof run);
  }
}

template <class T>
void decode_octahedral(std::span<std::byte> bytes) {
  for_each_run<T, 4>(bytes, [](std::array<T, 4>& v) {
    if (v[2] == 0) return;
    const auto one = static_cast<float>(v[2]);
    float x = static_cast<float>(v[0]) / one, y = static_cast<float>(v[1]) / one;
    float z = 1 - std::abs(x) - std::abs(y);
    // The lower half of the octahedron is folded over the corners of the square.
    const float t = std::min(z, 0.0f);
    x -= std::copysign(t, x);
    y -= std::copysign(t, y);
    const float length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0)) return;
    v[0] = rounded_to<T>(x / length);
    v[1] = rounded_to<T>(y / length);
    v[2] = rounded_to<T>(z / length);
  });
}

void decode_quaternions(std::span<std::byte> bytes) {
  for_each_run<std::int16_t, 4>(bytes, [](std::array<std::int16_t, 4>& v) {
    const float scale = static_cast<float>(std::sqrt(0.5)) / static_cast<float>(v[3] | 3);
    const std::array<float, 3> stored{static_cast<float>(v[0]) * scale, static_cast<float>(v[1]) * scale,
                                      static_cast<float>(v[2]) * scale};
    const float left = 1 - stored[0] * stored[0] - stored[1] * stored[1] - stored[2] * stored[2];
    const auto largest = static_cast<std::size_t>(v[3] & 3);
    for (std::size_t k = 0; k < 3; ++k) v[(largest + 1 + k) % 4] = rounded_to<std::int16_t>(stored[k]);
    v[largest] = rounded_to<std::int16_t>(std::sqrt(std::max(left, 0.0f)));
  });
}

void decode_exponents(std::span<std::byte> bytes) {
  for_each_run<std::uint32_t, 1>(bytes, [](std::array<std::uint32_t, 1>& v) {
    const auto exponent = static_cast<std::int8_t>(v[0] >> 24);
    const auto mantissa = static_cast<std::int32_t>(v[0] << 8) >> 8;
    const float value = std::ldexp(static_cast<float>(mantissa), exponent);
    std::memcpy(v.data(), &value, sizeof value);
  });
}

}  // namespace

void apply_meshopt_filter(const MeshoptView& view, std::span<std::byte> elements) {
  switch (view.filter) {
    case MeshoptFilter::none:
      return;
    case MeshoptFilter::octahedral:
      return view.stride == 4 ? decode_octahedral<std::int8_t>(elements) : decode_octahedral<std::int16_t>(elements);
    case MeshoptFilter::quaternion:
      return decode_quaternions(elements);
    case MeshoptFilter::exponential:
      return decode_exponents(elements);
  }
}

}  // namespace ligne
