#pragma once
/// Pairs the strokes at a node that continue each other.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

/// One end of a stroke at a node: the direction in which the stroke leaves the node, in lattice steps, and the number
/// of the end.
struct NodeArm {
  LatticePoint direction;
  std::uint32_t end = 0;
};

/// Largest number of arms for which every pair is compared. More arms are paired by a sweep around the node.
inline constexpr std::size_t kFewArms = 12;

/// Pairs the arms of one node: partner[arm.end] becomes the other arm's end. Ends without a partner keep their value.
/// Two arms are paired at any angle. Of more arms the straightest pair is taken first, then the straightest of the
/// rest, up to a turn of 90 degrees; equal turns are ordered by the numbers of the ends. `arms` must be in the order of
/// their ends.
void pair_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner);

/// The two algorithms for more than two arms. Their results are equal if no two turns are equal.
void pair_few_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner);
void pair_many_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner);

}  // namespace ligne
