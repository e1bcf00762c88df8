#pragma once
/// Which of the strokes that meet at a node continue each other.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

/// One end of a stroke at a node: the way the stroke leaves it, in lattice steps, and the number of the end.
struct NodeArm {
  LatticePoint direction;
  std::uint32_t end = 0;
};

/// Arms up to this number are paired by looking at every pair, more by a sweep round the node.
inline constexpr std::size_t kFewArms = 12;

/// Pairs the arms of one node: partner[arm.end] becomes the other arm's end; ends without a partner are left as they are.
/// Two arms are paired whatever their angle. Of more the straightest pair goes first, then the straightest of the rest,
/// up to a turn of 90 degrees; equal turns go by the numbers of the ends. `arms` are in the order of their ends.
void pair_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner);

/// The two ways of doing it, for more than two arms. They agree where no two turns are equal.
void pair_few_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner);
void pair_many_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner);

}  // namespace ligne
