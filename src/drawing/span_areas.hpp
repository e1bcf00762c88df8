#pragma once
/// From spans to areas: what vector files hold in the place of gray pixels.

#include <vector>

#include "drawing/result_models.hpp"

namespace ligne {

/// The areas whose spans these are, each of one face, without holes.
///
/// Spans of one face that lie one below the other, and nothing else of that face beside them, are one area; where it divides
/// or grows together, new ones begin. Its sides are what the ends of the spans lie on: straight lines, to a micrometre, that
/// go on to where they meet between two scan lines. Where they do not meet there, which is so at level borders, it ends half
/// way between the lines. So it is right but for what is smaller than the distance of two scan lines.
std::vector<Region> areas_of_spans(const SpanModel& spans);

}  // namespace ligne
