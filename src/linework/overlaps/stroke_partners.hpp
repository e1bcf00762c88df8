#pragma once
/// Which strokes coincide with another one.

#include <cstdint>
#include <vector>

#include "linework/stroke.hpp"

namespace ligne {

enum class Partners : std::uint8_t {
  cannot,  ///< too short, or neither it nor what lies near may coincide (Stroke::needs_overlap_check)
  none,    ///< it may coincide, but does with none
  some,    ///< it has an interval in common with another stroke, and one of the two may coincide
};

/// Compares the strokes with each other, in parallel: O(n log n) and the pairs that have ends near each other's lines.
std::vector<Partners> find_partners(const std::vector<Stroke>& strokes, double tolerance_steps);

/// The strokes numbered in `of` that coincide with some of the others, in the order of their numbers.
std::vector<std::uint32_t> find_partners_of(const std::vector<Stroke>& others, const std::vector<Stroke>& strokes,
                                            const std::vector<std::uint32_t>& of, double tolerance_steps);

}  // namespace ligne
