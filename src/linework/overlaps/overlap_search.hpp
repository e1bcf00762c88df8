#pragma once
/// The search for overlapping strokes.

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/search/segment_end_tree.hpp"
#include "linework/overlaps/compared_strokes.hpp"

namespace ligne {

/// Two strokes that overlap (segment_overlap.hpp), by number; earlier < later.
struct StrokePair {
  std::uint32_t later, earlier;
  auto operator<=>(const StrokePair&) const = default;
};

/// Finds overlaps among strokes of which some are replaced from call to call. The strokes that are added in a call make a
/// group of their own, or join the group before them when they are at least half as many, or when more than half of its
/// strokes are gone. So a stroke is filed O(log n) times.
class OverlapSearch {
 public:
  explicit OverlapSearch(double tolerance_steps) : tolerance_(tolerance_steps) {}

  /// Returns, in ascending order, the overlapping pairs of which at least one stroke is new, and at least one needs a check
  /// (Stroke::needs_overlap_check). All strokes are longer than the tolerance; those that are not new were new in a call
  /// before. Where two strokes overlap, an end of the shorter one lies on the longer one. So the search follows each stroke
  /// past the ends of those that are not longer: past the ends of all short strokes, and if the stroke is long, also past
  /// the ends of the long strokes of nearly its direction. Runs in parallel. Takes O(n log n), plus one test for each pair
  /// where an end of one lies near the line of the other and their directions are similar.
  std::vector<StrokePair> find_new(const ComparedStrokes& compared);

 private:
  /// Files the ends of new strokes. Returns them by themselves if they join others, or nothing if they make the last group.
  /// `place` tells the place of the stroke with an id, or kNone.
  std::optional<SegmentEnds> file(std::vector<PlacedEnd> added, const std::vector<std::uint32_t>& place);

  double tolerance_;
  std::vector<SegmentEnds> groups_;  ///< the last holds the new strokes; ends have ids of strokes, some of which are gone
};

}  // namespace ligne
