#pragma once
/// The rim of an area that is given by runs on lines. Private to plotting.

#include <cstdint>
#include <span>
#include <vector>

#include "plotting/hatching/hatch.hpp"

namespace ligne {

/// An interval of u on a line, mm.
struct HatchInterval {
  double from, to;
};

/// Draws strokes round the intervals of neighbouring lines. Line i lies at v = (first + i) x line_mm, and its intervals
/// are ascending. The strokes stay on the intervals and on the straight ways between their ends. Strokes that continue
/// each other end in the same point.
void trace_rim(std::span<const std::vector<HatchInterval>> lines, std::int32_t first, const HatchFrame& frame,
               double line_mm, Polylines& out);

}  // namespace ligne
