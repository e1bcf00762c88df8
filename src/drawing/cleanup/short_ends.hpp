#pragma once
/// Lines that end a little before the line that they run into.

#include <cstddef>

#include "drawing/cleanup/loose_ends.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

struct ShortEndLimits {
  double reach_mm = 0;     ///< how far a line may go on
  double touching_mm = 0;  ///< lines meet within this distance
};

/// Where a line of edges ends freely, and would run into another one if it went straight on, it does; else if it turned by
/// no more than 20 degrees, it goes on to the nearest place there: so it does not end beside a line of nearly its own
/// direction. A stroke is added, with a source of its own. Hidden strokes along it are cut. The line must be some times as
/// long as the way. Lines of the mesh stay, and nothing is led to them. No two visible strokes coincide. Returns the number
/// of such strokes. O(n + m), with m the grid cells of the side of `reach_mm` that lines pass.
std::size_t extend_short_ends(StrokeModel& model, const ShortEndLimits& limits, const MakeSource& make_source);

}  // namespace ligne
