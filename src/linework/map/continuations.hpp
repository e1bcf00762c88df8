#pragma once
/// Pairs the ends at a node that continue each other, and follows the lines that the pairs make.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "linework/map/nodes.hpp"

namespace ligne {

/// One end of a stroke at a node: the direction in which the stroke leaves the node, in lattice steps, and the number
/// of the end.
struct NodeArm {
  LatticePoint direction;
  std::uint32_t end = 0;
};

/// The arm of a stroke from a node at `p` to its other end.
inline NodeArm arm_from(LatticePoint p, LatticePoint far, std::uint32_t end) { return {{far.x - p.x, far.y - p.y}, end}; }

/// Makes two ends continue each other.
inline void join_ends(std::span<std::uint32_t> partner, std::uint32_t a, std::uint32_t b) {
  partner[a] = b;
  partner[b] = a;
}

/// Pairs the arms of one node: partner[arm.end] becomes the other arm's end. Ends without a partner keep their value.
/// Two arms are paired at any angle. Of more arms the straightest pair is taken first, then the straightest of the
/// rest, up to a turn of 90 degrees; equal turns are ordered by the numbers of the ends. `arms` must be in the order of
/// their ends.
void pair_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner);

/// Largest number of arms for which every pair is compared. More arms are paired by a sweep around the node.
inline constexpr std::size_t kFewArms = 12;

/// The two algorithms for more than two arms. Their results are equal if no two turns are equal.
void pair_few_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner);
void pair_many_arms(std::span<const NodeArm> arms, std::span<std::uint32_t> partner);

/// The order in which lines are followed, and where they begin.
enum class LineOrder {
  loose_ends,  ///< first the open lines, by their lowest loose ends; then the rings, by their lowest strokes
  strokes,     ///< by their lowest strokes, each line in the direction of that stroke
};

/// Calls visit(ends, is_ring) for each line of strokes whose ends continue each other: partner[e] is the end that
/// continues end e, or kNone. `ends` are the first ends of the strokes in the order of the line. A ring begins with its
/// lowest stroke. O(n).
template <class Visit>
void for_each_line(std::span<const std::uint32_t> partner, LineOrder order, const Visit& visit) {
  std::vector<std::uint8_t> is_followed(partner.size() / 2, 0);
  std::vector<std::uint32_t> ends;
  const auto follow = [&](std::uint32_t start) {
    ends.clear();
    std::uint32_t end = start;
    for (; end != kNone && !is_followed[end / 2]; end = partner[end ^ 1]) {
      is_followed[end / 2] = 1;
      ends.push_back(end);
    }
    visit(std::span<const std::uint32_t>(ends), end != kNone);
  };
  const auto count = static_cast<std::uint32_t>(partner.size());
  if (order == LineOrder::loose_ends) {
    for (std::uint32_t end = 0; end < count; ++end) {
      if (partner[end] == kNone && !is_followed[end / 2]) follow(end);
    }
  }
  for (std::uint32_t first = 0; first < count; first += 2) {
    if (is_followed[first / 2]) continue;
    std::uint32_t start = first;
    while (partner[start] != kNone && (partner[start] ^ 1) != first) start = partner[start] ^ 1;
    follow(partner[start] == kNone ? start : first);
  }
}

}  // namespace ligne
