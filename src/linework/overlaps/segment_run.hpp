#pragma once
/// Segments that follow each other on one line: a stroke on that line which loses to all of them loses one interval.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace ligne {

/// The order in which two strokes go, for one stroke, or for the last of several.
struct StrokeOrder {
  std::size_t rank = 0;
  float z = 0;  ///< farthest depth
  std::uint32_t source = 0;

  static StrokeOrder last_of(const StrokeOrder& a, const StrokeOrder& b) {
    return {std::max(a.rank, b.rank), std::max(a.z, b.z), std::max(a.source, b.source)};
  }
};

/// In the coordinates of a frame (linework/overlaps/stroke_directions.hpp). All the segments lie within `aside` in v of the
/// line from (u0, v0) to (u1, v1), which they cover but for gaps that are shorter than any piece of a stroke.
struct SegmentRun {
  double u0, v0, u1, v1;
  double aside = 0;
  std::uint32_t first, last;  ///< numbers of the segments at the two ends
  StrokeOrder order{};

  double v_at(double u) const { return u1 > u0 ? v0 + (u - u0) / (u1 - u0) * (v1 - v0) : v0; }

  /// Both as one; nothing when there is a gap, one of them ends within the other or they are on different lines: by more
  /// than `slack`.
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
