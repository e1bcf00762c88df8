#pragma once
/// Choice of a plane that divides a set of pieces: the best of some candidates.

#include <cstdint>
#include <span>

#include "base/hash.hpp"
#include "base/no_index.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne {

struct DividingPlane {
  ModelPlane plane;
  std::uint32_t face = kNone;  ///< face in this plane; kNone: none
};

struct PlaneChoice {
  unsigned candidates = 5;  ///< faces tried, chosen at random
  /// Sets of many pieces may also be divided by planes of no face. With face planes alone the BSP tree of a convex body of n
  /// faces has depth n.
  bool free_planes = true;
};

/// Divides a non-empty set. Equal seeds give equal choices.
DividingPlane choose_plane(const ModelPieces& pieces, std::span<const std::uint32_t> set, const PlaneChoice& choice,
                           std::uint64_t seed);

/// A pseudo-random number from another number.
inline std::uint64_t scramble(std::uint64_t x) { return mix_bits(x + kGoldenRatio); }

}  // namespace ligne
