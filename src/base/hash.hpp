#pragma once
/// Hashes of numbers. They do not resist an attacker who chooses the keys. Collisions cost time but do not change
/// results.

#include <bit>
#include <cstdint>

namespace ligne {

/// Multiplier of Fibonacci hashing: 2^64 divided by the golden ratio, rounded to an odd number. Products with it spread
/// consecutive keys evenly (Knuth, The Art of Computer Programming 3, 6.4).
inline constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15u;

/// Mixes the bits of x, so that every bit of the result depends on all of them: the finalizer of SplitMix64.
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// The hash of a sequence of numbers, from the hash of all but the last and that last number.
constexpr std::uint64_t extend_hash(std::uint64_t hash, std::uint64_t number) {
  hash = (hash ^ number) * kGoldenRatio;
  return hash ^ (hash >> 32);
}

/// The bit pattern of x, except that -0 gives that of +0, so that equal numbers have equal patterns.
inline std::uint64_t bits_of_number(double x) { return std::bit_cast<std::uint64_t>(x + 0.0); }

}  // namespace ligne
