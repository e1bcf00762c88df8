#pragma once
/// Runs: segments that follow each other on one line. A stroke on that line that loses to all of them loses one
/// interval.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace ligne {

/// The order of precedence of a stroke, or an upper bound for several strokes.
struct StrokeOrder {
  std::size_t rank = 0;
  float z = 0;  ///< farthest depth
  std::uint32_t source = 0;

  static StrokeOrder last_of(const StrokeOrder& a, const StrokeOrder& b) {
    return {std::max(a.rank, b.rank), std::max(a.z, b.z), std::max(a.source, b.source)};
  }
};

/// A run in the coordinates of a frame (linework/overlaps/stroke_directions.hpp). All its segments lie within `aside`
/// in v of the line from (u0, v0) to (u1, v1). They cover this line except for gaps shorter than any piece of a stroke.
struct SegmentRun {
  double u0, v0, u1, v1;
  double aside = 0;
  std::uint32_t first, last;  ///< numbers of the segments at the two ends
  StrokeOrder order{};

  double v_at(double u) const { return u1 > u0 ? v0 + (u - u0) / (u1 - u0) * (v1 - v0) : v0; }

  /// Joins two runs. Returns nothing if the gap between them or their distance from the common line is above `slack`,
  /// or if one run ends inside the other.
  static std::optional<SegmentRun> joined(SegmentRun a, SegmentRun b, double slack) {
    if (b.u0 < a.u0) std::swap(a, b);
    if (b.u0 > a.u1 + slack || b.u1 <= a.u1) return std::nullopt;
    SegmentRun both{a.u0, a.v0, b.u1, b.v1, 0, a.first, b.last, StrokeOrder::last_of(a.order, b.order)};
    both.aside = std::max(std::abs(a.v1 - both.v_at(a.u1)) + a.aside, std::abs(b.v0 - both.v_at(b.u0)) + b.aside);
    if (both.aside > slack) return std::nullopt;
    return both;
  }
};

}  // namespace ligne
