#pragma once
/// Strokes put together to arcs: lines that run from one junction to the next.

#include <cstdint>
#include <span>
#include <vector>

#include "linework/stroke.hpp"

namespace ligne {

/// A part of a stroke, by fractions of its length on the page.
struct ArcPart {
  std::uint32_t stroke = 0;
  double from = 0, to = 1;
  LatticePoint p_from, p_to;
  bool reversed = false;  ///< the arc runs from `to` to `from`
};

struct StrokeArc {
  std::vector<ArcPart> parts;  ///< in the order in which the arc runs through them
  bool closed = false;         ///< a ring without a junction
};

/// The arcs of the strokes `members`. A junction is a point at which one of them ends, or three or more, or at which one of
/// them ends within `tolerance_steps` of the inside of another, or where two cross. Strokes without length have no part.
std::vector<StrokeArc> stroke_arcs(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members,
                                   double tolerance_steps);

}  // namespace ligne
