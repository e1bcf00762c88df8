#include "linework/overlaps/compared_strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/indices_where.hpp"
#include "base/parallel.hpp"
#include "geometry/search/line_cells.hpp"
#include "geometry/search/segment_end_tree.hpp"
#include "geometry/segment_overlap.hpp"

namespace ligne {
namespace {

constexpr std::size_t kFollowed = 4096;  ///< ends in a task

/// Number of ranges of directions. A long stroke searches one or two of them. Adjustable.
constexpr std::size_t kRanges = 14;
constexpr std::size_t kShort = kRanges;  ///< the group of the short strokes, whose directions mean little

std::size_t range_of(double direction) {
  constexpr double kRange = line_directions::kCircle / kRanges;
  static_assert(2 * kDirectionReach < kRange);
  return static_cast<std::size_t>(std::floor(direction / kRange) + double{kRanges}) % kRanges;
}

/// The ends of strokes: a tree for each range of directions, and one for the short strokes.
class FiledEnds {
 public:
  FiledEnds(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members, double tolerance)
      : longest_short_(kLongInTolerances * tolerance) {
    std::array<std::vector<PlacedEnd>, kRanges + 1> ends;
    for (const std::uint32_t i : members) {
      const Stroke& s = strokes[i];
      const bool is_long = page_length(s) > longest_short_;
      std::vector<PlacedEnd>& group = ends[is_long ? range_of(line_directions::direction(s.from, s.to)) : kShort];
      group.push_back({s.from, s.to, i});
      group.push_back({s.to, s.from, i});
    }
    parallel_tasks(trees_.size(), [&](std::size_t g) {
      const double middle = g == kShort ? 1 : (static_cast<double>(g) + 0.5) * line_directions::kCircle / kRanges;
      trees_[g] = SegmentEndTree(std::exchange(ends[g], {}), middle, tolerance);
    });
  }

  const std::array<SegmentEndTree, kRanges + 1>& trees() const { return trees_; }

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
  double longest_short_;
  std::array<SegmentEndTree, kRanges + 1> trees_;
};

}  // namespace

std::vector<std::uint32_t> strokes_near(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> others,
                                        double tolerance_steps) {
  // Adjustable: least side of a cell, a 2048th of the lattice; number of cells along the lattice for each stroke along it;
  // smallest ratio of all strokes to the others. The test of a stroke takes about a third of a comparison.
  constexpr double kLeastCell = 1 << 15, kCellsEach = 8;
  constexpr std::size_t kTimes = 2;
  if (kTimes * others.size() > strokes.size()) return indices_where(strokes.size(), [](std::size_t) { return true; });
  const double along = kCellsEach * std::sqrt(static_cast<double>(others.size()) + 1);
  LineCells cells(walked_cell(strokes, std::max(kLeastCell, 2 * kLatticeLimit / along)));
  for (const std::uint32_t i : others) cells.insert(i, strokes[i].from, strokes[i].to);
  return indices_where(strokes.size(), [&](std::size_t i) {
    return cells.near(strokes[i].from, strokes[i].to, tolerance_steps, [](std::uint32_t) { return true; });
  });
}

std::vector<StrokePair> find_new_overlaps(const ComparedStrokes& compared, double tolerance_steps) {
  const std::vector<Stroke>& strokes = compared.strokes;
  const auto is_new = [&](std::size_t i) { return compared.is_new[i] != 0; };
  const std::vector<std::uint32_t> added = indices_where(strokes.size(), is_new);
  const std::vector<std::uint32_t> near = strokes_near(strokes, added, tolerance_steps);
  const FiledEnds filed(strokes, near, tolerance_steps);
  std::optional<FiledEnds> filed_new;  // where not all are new
  if (added.size() < near.size()) filed_new.emplace(strokes, added, tolerance_steps);
  std::vector<StrokePair> pairs;
  // In the order of the trees, neighbours are near each other on the page and in memory.
  for (const SegmentEndTree& tree : filed.trees()) {
    const std::vector<PlacedEnd>& ends = tree.ends();
    std::vector<std::vector<StrokePair>> found(block_count(ends.size(), kFollowed));
    parallel_blocks(ends.size(), kFollowed, [&](std::size_t begin, std::size_t last) {
      for (std::size_t e = begin; e < last; ++e) {
        if (!(ends[e].p < ends[e].far)) continue;
        const std::uint32_t own = ends[e].segment;
        const Stroke& s = strokes[own];
        const FiledEnds& others = !filed_new || is_new(own) ? filed : *filed_new;
        others.for_each_along({s.from, s.to}, [&](const PlacedEnd& end) {
          const Stroke& t = strokes[end.segment];
          if (end.segment == own || !(s.needs_overlap_check || t.needs_overlap_check)) return;
          if (!overlap(s.from, s.to, t.from, t.to, tolerance_steps)) return;
          found[begin / kFollowed].push_back({std::max(own, end.segment), std::min(own, end.segment)});
        });
      }
    });
    for (const std::vector<StrokePair>& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  }
  parallel_sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace ligne
