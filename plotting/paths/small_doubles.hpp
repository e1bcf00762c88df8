#pragma once
/// Finds small lines that coincide as a whole. Private to plotting/paths.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/lattice.hpp"

namespace ligne {

/// Per line, which has the `points` from begin[i] to begin[i + 1]: 1 if it and an earlier line that stays lie on each
/// other along their whole lengths, within the tolerance. Starting points and directions may differ. Only lines of at
/// most kSmallLength tolerances, with short segments, are tested: longer segments are found to coincide one by one.
/// Time O(n log n).
std::vector<char> small_doubles(std::span<const Point2> points, std::span<const std::uint32_t> begin, const Lattice& lattice,
                                double tolerance_mm);

/// Largest length of a small line, in tolerances. Simplification (JoinTolerances::simplify_loss) leaves segments
/// shorter than a tolerance in circles of less than 25 tolerances across; this is the length of somewhat larger
/// circles. Adjustable.
inline constexpr double kSmallLength = 128;
/// Most lines with nearly the same centre that a new line is compared with, so that heaps of lines take no longer.
/// Adjustable.
inline constexpr int kMostCompared = 64;

}  // namespace ligne
