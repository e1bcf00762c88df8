#pragma once
/// Finds the strokes that lie on another stroke.

#include <cstdint>
#include <vector>

#include "linework/stroke.hpp"

namespace ligne {

enum class OverlapState : std::uint8_t {
  excluded,     ///< too short, or neither it nor a stroke near it needs a check (Stroke::needs_overlap_check)
  alone,        ///< checked; it overlaps no other stroke
  overlapping,  ///< it has an interval in common with another stroke, and one of the two needs a check
};

/// Returns the state of each stroke. Runs in parallel. Takes O(n log n), plus one test for each pair of strokes where
/// one has an end near the line of the other.
std::vector<OverlapState> find_overlapping_strokes(const std::vector<Stroke>& strokes, double tolerance_steps);

/// The strokes numbered in `of` that overlap one of `others`, in the order of their numbers.
std::vector<std::uint32_t> strokes_that_overlap(const std::vector<Stroke>& others, const std::vector<Stroke>& strokes,
                                                const std::vector<std::uint32_t>& of, double tolerance_steps);

}  // namespace ligne
