#pragma once
/// The choice of a plane that divides a set of pieces: of some candidates the one that cuts the fewest.

#include <cstdint>
#include <span>

#include "base/hash.hpp"
#include "base/no_index.hpp"
#include "visibility/order/model_pieces.hpp"

namespace ligne {

struct DividingPlane {
  ModelPlane plane;
  std::uint32_t face = kNone;  ///< whose plane it is; kNone: a plane of no face
};

struct PlaneChoice {
  unsigned candidates = 5;  ///< faces that are tried, at random
  /// Sets of many pieces may be divided by planes of no face too. With planes of faces alone the bsp tree of a convex body
  /// of n faces has depth n.
  bool free_planes = true;
};

/// Divides a set that is not empty. With the same seed the choice is the same.
DividingPlane choose_plane(const ModelPieces& pieces, std::span<const std::uint32_t> set, const PlaneChoice& choice,
                           std::uint64_t seed);

/// A number that looks like chance, from another one.
inline std::uint64_t scramble(std::uint64_t x) { return mix_bits(x + kGoldenRatio); }

}  // namespace ligne
