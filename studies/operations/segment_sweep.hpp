#pragma once
/// All points in which segments meet, [Boulle1980] 3.2.1.2: by a sweep (Bentley and Ottmann), and by all pairs. Both exact.

#include <compare>
#include <cstdint>
#include <vector>

#include "geometry/exact_segment.hpp"

namespace ligne::studies {

/// Largest coordinate with which the sweep's products stay below 2^127.
inline constexpr std::int32_t kSweepLimit = 1 << 14;

/// A point with rational coordinates x / w and y / w, in lowest terms, w > 0; by x, then by y.
struct MeetingPoint {
  std::int64_t x = 0, y = 0, w = 1;
  friend bool operator==(const MeetingPoint&, const MeetingPoint&) = default;
  friend std::strong_ordering operator<=>(const MeetingPoint& a, const MeetingPoint& b);
};

struct SweepWork {
  std::uint64_t events = 0;       ///< points at which the sweep stopped
  std::uint64_t comparisons = 0;  ///< of segments with points, and of segments with each other, in the tree
  std::uint64_t pairs = 0;        ///< pairs of segments tested
};

/// The points in which two or more of the segments meet, in order, each once. Segments have two different ends with
/// |coordinates| <= kSweepLimit, in any position: upright, meeting in one point, lying on each other (of two that do, the
/// ends of what they have in common are given). Invariant of the sweep: at every stop the tree holds the segments that meet
/// the sweep line there, in the order in which they cross it just behind the stop.
std::vector<MeetingPoint> meetings_by_sweep(const std::vector<LatticeSegment>& segments, SweepWork& work);
std::vector<MeetingPoint> meetings_by_pairs(const std::vector<LatticeSegment>& segments, SweepWork& work);

}  // namespace ligne::studies
