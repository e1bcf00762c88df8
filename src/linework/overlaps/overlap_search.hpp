#pragma once
/// Finds the pairs of strokes that lie on each other.

#include <array>
#include <compare>
#include <cstdint>
#include <deque>
#include <vector>

#include "linework/overlaps/compared_strokes.hpp"
#include "linework/overlaps/stroke_end_tree.hpp"

namespace ligne {

/// Two strokes that overlap (stroke_overlap.hpp), by number; first < second.
struct StrokePair {
  std::uint32_t first, second;
  auto operator<=>(const StrokePair&) const = default;
};

/// Returns for each stroke 1 if it may overlap one of `others`, which are numbers of strokes, or is one of them. Exact only
/// where these are a minority. Runs in parallel.
std::vector<std::uint8_t> strokes_near(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& others,
                                       double tolerance_steps);

/// Finds overlaps by the ends of strokes. Where two strokes overlap, each end of their common interval is an end of one of
/// them that lies on the other. So the search follows each stroke past the ends of the others: past the ends of all short
/// strokes, and if the stroke is long, also past the ends of the long strokes of nearly its direction.
class OverlapSearch {
 public:
  /// Every stroke is longer than the tolerance.
  OverlapSearch(const ComparedStrokes& strokes, double tolerance_steps) : strokes_(strokes), tolerance_(tolerance_steps) {}

  /// Returns, in ascending order, the overlapping pairs with at least one stroke that was added since the last call, of
  /// which at least one needs a check (Stroke::needs_overlap_check). Runs in parallel. Takes O(n log n), plus one test for
  /// each pair where an end of one lies near the line of the other and their directions are similar.
  std::vector<StrokePair> new_pairs();

 private:
  /// Number of ranges of directions. A long stroke searches one or two of them. Adjustable.
  static constexpr std::size_t kRanges = 14;
  static constexpr std::size_t kShort = kRanges, kGroups = kRanges + 1;
  /// The trees by range of directions; the last one has all short strokes.
  using Trees = std::array<StrokeEndTree, kGroups>;

  static std::size_t range_of(double direction);
  std::size_t group_of(const Stroke& s) const;
  void file_new_strokes();
  void follow(std::uint32_t stroke, const Trees& trees, std::vector<StrokePair>& pairs) const;
  void compare(std::uint32_t a, std::uint32_t b, std::vector<StrokePair>& pairs) const;

  const ComparedStrokes& strokes_;
  double tolerance_;
  std::uint32_t filed_ = 0;         ///< number of strokes in trees
  std::vector<std::uint32_t> new_;  ///< those filed by the last call
  std::deque<Trees> trees_;         ///< one for each call
};

}  // namespace ligne
