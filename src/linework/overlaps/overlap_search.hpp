#pragma once
/// Finds the pairs of strokes that lie on each other.

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "linework/overlaps/compared_strokes.hpp"

namespace ligne {

/// Two strokes that overlap (stroke_overlap.hpp), by number; earlier < later.
struct StrokePair {
  std::uint32_t later, earlier;
  auto operator<=>(const StrokePair&) const = default;
};

/// Returns the numbers of the strokes that may overlap one of `others`, which are numbers of strokes too, and those of
/// `others`, ascending. Exact only where these are a minority. Runs in parallel.
std::vector<std::uint32_t> strokes_near(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> others,
                                        double tolerance_steps);

/// Returns, in ascending order, the overlapping pairs of which at least one stroke is new, and at least one needs a check
/// (Stroke::needs_overlap_check). All strokes are longer than the tolerance. Where two strokes overlap, each end of their
/// common interval is an end of one of them that lies on the other. So the search follows each stroke past the ends of the
/// others: past the ends of all short strokes, and if the stroke is long, also past the ends of the long strokes of nearly
/// its direction. Runs in parallel. Takes O(n log n), plus one test for each pair where an end of one lies near the line of
/// the other and their directions are similar.
std::vector<StrokePair> find_new_overlaps(const ComparedStrokes& compared, double tolerance_steps);

}  // namespace ligne
