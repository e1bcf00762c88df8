#pragma once
/// Numbers lattice points along a Morton curve [Morton1966]: points with near numbers are near in the plane.

#include <cstdint>

#include "geometry/lattice.hpp"

namespace ligne {

/// Interleaves the bits of x and y, the bit of y above that of x. Points whose coordinates have a size of at most
/// kLatticeLimit have equal keys only if they are equal. Let b be the highest bit that differs within a set of keys.
/// Points with a 0 there all have a smaller x than points with a 1 if b is even, and a smaller y if b is odd.
inline std::uint64_t morton_key(LatticePoint p) {
  const auto spread = [](std::int32_t coordinate) {
    auto v = static_cast<std::uint64_t>(std::int64_t{coordinate} + kLatticeLimit);
    v = (v | (v << 16)) & 0x0000ffff0000ffffu;
    v = (v | (v << 8)) & 0x00ff00ff00ff00ffu;
    v = (v | (v << 4)) & 0x0f0f0f0f0f0f0f0fu;
    v = (v | (v << 2)) & 0x3333333333333333u;
    return (v | (v << 1)) & 0x5555555555555555u;
  };
  return spread(p.x) | (spread(p.y) << 1);
}

}  // namespace ligne
