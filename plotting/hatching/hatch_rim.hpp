#pragma once
/// The rim of an area that is given by runs on lines. Private to plotting.

#include <cstdint>
#include <span>
#include <vector>

#include "plotting/hatching/hatch.hpp"

namespace ligne {

/// A part of a line, u.
struct HatchInterval {
  double from, to;
};

/// Strokes round the intervals of neighbouring lines, which lie at v = (first + i) x line_mm; ascending on each. They stay
/// on the intervals and on the straight ways between their ends. Strokes that continue each other end in the same point.
void trace_rim(std::span<const std::vector<HatchInterval>> lines, std::int32_t first, const HatchFrame& frame,
               double line_mm, Polylines& out);

}  // namespace ligne
