#pragma once
/// A way through strokes, improved by 2-opt and or-opt. Private to plotting/paths.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Strokes are numbered; end 2 s is the first point of stroke s, end 2 s + 1 its last. A tour is a list of ends at which
/// strokes are entered; each is left at the other end, `end ^ 1`. The gaps between strokes are what is made shorter.
struct Tour {
  std::vector<std::uint32_t> entries;
};

/// The first stroke of the tour stays where it is (the home position); so does the last when `returns`, else what follows
/// the last stroke costs nothing. `ends` holds the points of all ends. Stops when no move gains, or when `work` (strokes
/// moved and pairs tried) is used up.
/// `near` is what it found of the ends' neighbours, for the next time with the same ends; empty: nothing yet.
void improve(Tour& tour, std::span<const Point2> ends, bool returns, std::uint64_t& work, std::vector<std::uint32_t>& near);

}  // namespace ligne
