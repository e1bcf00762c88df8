#pragma once
/// Hashes of numbers, for tables that are not attacked: collisions cost time, and results do not depend on them.

#include <bit>
#include <cstdint>

namespace ligne {

/// 2^64 divided by the golden ratio, made odd. Products with it spread neighbouring keys evenly (Knuth, The Art of Computer
/// Programming 3, 6.4).
inline constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15u;

/// A number each of whose bits depends on all bits of x: the finalizer of SplitMix64.
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// The hash of a row of numbers, extended by one more.
constexpr std::uint64_t extend_hash(std::uint64_t hash, std::uint64_t number) {
  hash = (hash ^ number) * kGoldenRatio;
  return hash ^ (hash >> 32);
}

/// The bits of x; those of +0 for -0, so that equal numbers have equal bits.
inline std::uint64_t bits_of_number(double x) { return std::bit_cast<std::uint64_t>(x + 0.0); }

}  // namespace ligne
