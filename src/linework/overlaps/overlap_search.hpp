#pragma once
/// The search for overlapping strokes.

#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/search/segment_end_tree.hpp"
#include "linework/overlaps/compared_strokes.hpp"

namespace ligne {

/// Two strokes that overlap (segment_overlap.hpp), by number; earlier < later.
struct StrokePair {
  std::uint32_t later, earlier;
  auto operator<=>(const StrokePair&) const = default;
};

/// The ends of strokes: a tree for each range of directions, and one for the short strokes, whose directions mean little.
class FiledEnds {
 public:
  FiledEnds() = default;
  /// `ends` holds both ends of each stroke.
  FiledEnds(std::span<const PlacedEnd> ends, double tolerance_steps);

  std::size_t size() const { return size_; }

  /// Calls visit(ends of a tree) for each tree. Neighbours in a tree are near each other on the page and in memory.
  template <class Visit>
  void for_each_tree(const Visit& visit) const {
    for (const SegmentEndTree& tree : trees_) visit(tree.ends());
  }

  /// Calls visit(end) for the ends along a segment of all short strokes, and of the long strokes of nearly its direction if
  /// it is long.
  template <class Visit>
  void for_each_along(const DirectedSegment& segment, const Visit& visit) const {
    trees_[kShort].for_each_along(segment, visit);
    if (segment.length <= longest_short_) return;
    const std::size_t low = range_of(segment.direction - kDirectionReach),
                      high = range_of(segment.direction + kDirectionReach);
    trees_[low].for_each_along(segment, visit);
    if (high != low) trees_[high].for_each_along(segment, visit);
  }

 private:
  /// Number of ranges of directions. A long stroke searches one or two of them. Adjustable.
  static constexpr std::size_t kRanges = 20;
  static constexpr std::size_t kShort = kRanges;  ///< the group of the short strokes

  static std::size_t range_of(double direction) {
    constexpr double kRange = line_directions::kCircle / kRanges;
    static_assert(2 * kDirectionReach < kRange);
    return static_cast<std::size_t>(std::floor(direction / kRange) + double{kRanges}) % kRanges;
  }

  double longest_short_ = 0;
  std::size_t size_ = 0;
  std::array<SegmentEndTree, kRanges + 1> trees_;
};

/// Finds overlaps among strokes of which some are replaced from call to call. The strokes that are added in a call make a
/// group of their own, or join the group before them when they are at least half as many, or when more than half of its
/// strokes are gone. So a stroke is filed a few times at most.
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
  /// Files the ends of new strokes. `place` tells the place of the stroke with an id, or kNone.
  void file(std::span<const PlacedEnd> added, const std::vector<std::uint32_t>& place);

  double tolerance_;
  std::vector<FiledEnds> groups_;  ///< the last holds the new strokes; ends have ids of strokes, some of which are gone
};

}  // namespace ligne
