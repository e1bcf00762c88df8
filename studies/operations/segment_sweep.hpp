#pragma once
/// All points where segments meet, [Boulle1980] 3.2.1.2: by a sweep (Bentley and Ottmann), and by all pairs. Both are exact.

#include <compare>
#include <cstdint>
#include <vector>

#include "geometry/exact_segment.hpp"

namespace ligne::studies {

/// Largest coordinate for which the products of the sweep stay below 2^127.
inline constexpr std::int32_t kSweepLimit = 1 << 14;

/// A point with rational coordinates x / w and y / w in lowest terms, w > 0. Ordered by x, then by y.
struct MeetingPoint {
  std::int64_t x = 0, y = 0, w = 1;
  friend bool operator==(const MeetingPoint&, const MeetingPoint&) = default;
  friend std::strong_ordering operator<=>(const MeetingPoint& a, const MeetingPoint& b);
};

struct SweepWork {
  std::uint64_t events = 0;       ///< stops of the sweep
  std::uint64_t comparisons = 0;  ///< comparisons in the tree, of segments with points and with each other
  std::uint64_t pairs = 0;        ///< pairs of segments tested
};

/// The points where two or more segments meet, sorted, each once. The two ends of a segment differ, with |coordinates| <=
/// kSweepLimit. Segments may be vertical, meet in one point, or overlap (the ends of the overlap are given). Invariant: at
/// every stop the tree holds the segments that meet the sweep line, in their order just behind the stop.
std::vector<MeetingPoint> meetings_by_sweep(const std::vector<LatticeSegment>& segments, SweepWork& work);
std::vector<MeetingPoint> meetings_by_pairs(const std::vector<LatticeSegment>& segments, SweepWork& work);

}  // namespace ligne::studies
