#pragma once
/// Small lines that lie on each other whole. Private to plotting/paths.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// For each line, `points` from begin[i] to begin[i + 1], whether an earlier one that stays lies on it along its whole
/// length, within the tolerance, and it on that. Where they begin and which way they run does not matter. Only lines of at
/// most kSmallLength tolerances are looked at, of segments that are short as well: longer segments can be seen to lie on
/// each other one by one. Time O(n log n).
std::vector<char> small_doubles(std::span<const Point2> points, std::span<const std::uint32_t> begin, double tolerance_mm);

/// Adjustable: circles of less than 25 tolerances across have segments shorter than one, by what simplification leaves
/// (JoinTolerances::simplify_loss); this is the length of somewhat larger ones.
inline constexpr double kSmallLength = 128;
/// Adjustable: of lines with one middle a new one is held against so many, so that heaps take no longer.
inline constexpr int kMostCompared = 64;

}  // namespace ligne
