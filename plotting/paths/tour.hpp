#pragma once
/// Tours through strokes, improved by 2-opt and or-opt. Private to plotting/paths.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.hpp"

namespace ligne {

/// Strokes are numbered; end 2 s is the first point of stroke s, end 2 s + 1 its last. A tour is a list of ends at
/// which strokes are entered; each is left at the other end, `end ^ 1`.
using Tour = std::vector<std::uint32_t>;

/// Shortens the gaps between the strokes of a tour. The first stroke stays in place (the home position); so does the
/// last if `returns`, else the way after the last stroke costs nothing. `ends` holds the points of all ends of the
/// strokes in the tour. Stops when no move gains, or when `work` (strokes moved and pairs tried) is used up.
void improve(Tour& tour, std::span<const Point2> ends, bool returns, std::uint64_t& work);

}  // namespace ligne
