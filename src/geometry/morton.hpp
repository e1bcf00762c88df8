#pragma once
/// Numbers of lattice points along a Morton curve [Morton1966]: what is near in number is near in the plane.

#include <cstdint>

#include "geometry/lattice.hpp"

namespace ligne {

/// The bits of x and of y by turns, y's above x's. Points with |coordinate| <= kLatticeLimit have the same key only when
/// they are the same point. Where the highest bit that differs within a set of keys is an even one, the points with a 0
/// there have all a smaller x than those with a 1; where it is odd, a smaller y.
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
