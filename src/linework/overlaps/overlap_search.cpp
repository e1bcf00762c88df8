#include "linework/overlaps/overlap_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "linework/map/line_cells.hpp"
#include "linework/overlaps/stroke_overlap.hpp"

namespace ligne {
namespace {

constexpr std::size_t kFollowed = 2048;  ///< strokes in a task

/// Calls follow(i, pairs) for all i below `count` in parallel, and appends the pairs in that order.
template <class Follow>
void gather_pairs(std::size_t count, std::vector<StrokePair>& pairs, const Follow& follow) {
  std::vector<std::vector<StrokePair>> found(block_count(count, kFollowed));
  parallel_blocks(count, kFollowed, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) follow(i, found[begin / kFollowed]);
  });
  for (const std::vector<StrokePair>& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
}

}  // namespace

std::vector<std::uint8_t> strokes_near(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& others,
                                       double tolerance_steps) {
  // Adjustable: least side of a cell, a 2048th of the lattice; number of cells along the lattice for each stroke along it;
  // smallest ratio of all strokes to the others. The test of a stroke takes about a third of a comparison.
  constexpr double kLeastCell = 1 << 15, kCellsEach = 8;
  constexpr std::size_t kTimes = 2;
  if (kTimes * others.size() > strokes.size()) return std::vector<std::uint8_t>(strokes.size(), 1);
  const double along = kCellsEach * std::sqrt(static_cast<double>(others.size()) + 1);
  LineCells cells(walked_cell(strokes, std::max(kLeastCell, 2 * kLatticeLimit / along)));
  for (const std::uint32_t i : others) cells.insert(i, strokes[i].from, strokes[i].to);
  std::vector<std::uint8_t> is_near(strokes.size());
  parallel_blocks(strokes.size(), kShortWorkBlock, [&](std::size_t begin, std::size_t end) {
    const auto found = [](std::uint32_t) { return true; };
    for (std::size_t i = begin; i < end; ++i)
      is_near[i] = cells.near(strokes[i].from, strokes[i].to, tolerance_steps, found);
  });
  return is_near;
}

std::size_t OverlapSearch::range_of(double direction) {
  constexpr double kRange = stroke_directions::kCircle / kRanges;
  static_assert(2 * kDirectionReach < kRange);
  return static_cast<std::size_t>(std::floor(direction / kRange) + double{kRanges}) % kRanges;
}

std::size_t OverlapSearch::group_of(const Stroke& s) const {
  if (page_length(s) <= kLongInTolerances * tolerance_) return kShort;
  return range_of(stroke_directions::direction(s.from, s.to));
}

void OverlapSearch::file_new_strokes() {
  new_.clear();
  std::vector<std::uint8_t> group;
  std::array<std::size_t, kGroups> count{};
  for (; filed_ < strokes_.strokes.size(); ++filed_) {
    if (strokes_.is_gone[filed_]) continue;
    new_.push_back(filed_);
    group.push_back(static_cast<std::uint8_t>(group_of(strokes_.strokes[filed_])));
    ++count[group.back()];
  }
  std::array<std::vector<PlacedEnd>, kGroups> ends;
  for (std::size_t g = 0; g < kGroups; ++g) ends[g].reserve(2 * count[g]);
  for (std::size_t k = 0; k < new_.size(); ++k) {
    const Stroke& s = strokes_.strokes[new_[k]];
    ends[group[k]].push_back({s.from, s.to, new_[k]});
    ends[group[k]].push_back({s.to, s.from, new_[k]});
  }
  Trees& trees = trees_.emplace_back();
  parallel_tasks(kGroups, [&](std::size_t g) {
    const double middle = g == kShort ? 1 : (static_cast<double>(g) + 0.5) * stroke_directions::kCircle / kRanges;
    trees[g] = StrokeEndTree(std::exchange(ends[g], {}), middle, tolerance_);
  });
}

std::vector<StrokePair> OverlapSearch::new_pairs() {
  const std::uint32_t first_new = filed_;
  file_new_strokes();
  std::vector<StrokePair> pairs;
  // In the order of the trees, neighbours are near each other on the page and in memory.
  for (const StrokeEndTree& tree : trees_.back()) {
    const std::vector<PlacedEnd>& ends = tree.ends();
    gather_pairs(ends.size(), pairs, [&](std::size_t e, std::vector<StrokePair>& found) {
      if (!(ends[e].p < ends[e].far)) return;
      for (const Trees& trees : trees_) follow(ends[e].stroke, trees, found);
    });
  }
  if (first_new > 0 && !new_.empty()) {
    const std::vector<std::uint8_t> is_near = strokes_near(strokes_.strokes, new_, tolerance_);
    gather_pairs(first_new, pairs, [&](std::size_t i, std::vector<StrokePair>& found) {
      if (is_near[i] && !strokes_.is_gone[i]) follow(static_cast<std::uint32_t>(i), trees_.back(), found);
    });
  }
  parallel_sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void OverlapSearch::follow(std::uint32_t stroke, const Trees& trees, std::vector<StrokePair>& pairs) const {
  const Stroke& s = strokes_.strokes[stroke];
  const DirectedSegment segment(s.from, s.to);
  const auto visit = [&](const PlacedEnd& other) { compare(stroke, other.stroke, pairs); };
  trees[kShort].for_each_along(segment, visit);
  if (segment.length <= kLongInTolerances * tolerance_) return;
  const std::size_t low = range_of(segment.direction - kDirectionReach),
                    high = range_of(segment.direction + kDirectionReach);
  trees[low].for_each_along(segment, visit);
  if (high != low) trees[high].for_each_along(segment, visit);
}

void OverlapSearch::compare(std::uint32_t a, std::uint32_t b, std::vector<StrokePair>& pairs) const {
  if (a == b || strokes_.is_gone[a] || strokes_.is_gone[b]) return;
  const auto [first, second] = std::minmax(a, b);
  const Stroke &s = strokes_.strokes[first], &t = strokes_.strokes[second];
  if (!s.needs_overlap_check && !t.needs_overlap_check) return;
  if (overlap(s.from, s.to, t.from, t.to, tolerance_)) pairs.push_back({first, second});
}

}  // namespace ligne
