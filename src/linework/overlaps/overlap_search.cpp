#include "linework/overlaps/overlap_search.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"

namespace ligne {

std::optional<SegmentEnds> OverlapSearch::file(std::vector<PlacedEnd> added, const std::vector<std::uint32_t>& place) {
  std::optional<SegmentEnds> newest;
  std::vector<PlacedEnd> stay;
  const std::size_t count = added.size();
  for (; !groups_.empty(); groups_.pop_back(), added.insert(added.end(), stay.begin(), stay.end())) {
    stay.clear();
    groups_.back().for_each_tree([&](const std::vector<PlacedEnd>& ends) {
      std::ranges::copy_if(ends, std::back_inserter(stay), [&](const PlacedEnd& e) { return place[e.segment] != kNone; });
    });
    if (stay.size() > 2 * added.size() && 2 * stay.size() > groups_.back().size()) break;
    if (added.size() == count && !stay.empty()) newest.emplace(added, tolerance_);
  }
  groups_.emplace_back(std::move(added), tolerance_);
  return newest;
}

std::vector<StrokePair> OverlapSearch::find_new(const ComparedStrokes& compared) {
  const std::vector<Stroke>& strokes = compared.strokes;
  std::vector<std::uint32_t> place(compared.next_id, kNone);
  std::vector<PlacedEnd> added;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    const LatticePoint from = strokes[i].from, to = strokes[i].to;
    place[compared.ids[i]] = i;
    if (compared.is_new(i)) added.insert(added.end(), {{from, to, compared.ids[i]}, {to, from, compared.ids[i]}});
  }
  const std::optional<SegmentEnds> newest = file(std::move(added), place);
  const std::span<const SegmentEnds> all(groups_), new_ones = newest ? std::span(&*newest, 1) : all.last(1);
  // In the order of the trees, neighbours are near each other on the page and in memory.
  constexpr std::size_t kFollowed = 1024;  // ends in a task
  std::vector<std::span<const PlacedEnd>> tasks;
  for (const SegmentEnds& group : groups_) {
    group.for_each_tree([&](std::span<const PlacedEnd> ends) {
      for (; !ends.empty(); ends = ends.subspan(tasks.back().size()))
        tasks.push_back(ends.first(std::min(ends.size(), kFollowed)));
    });
  }
  std::vector<std::vector<StrokePair>> found(tasks.size());
  parallel_for(tasks.size(), [&](std::size_t task) {
    for (const PlacedEnd& start : tasks[task]) {
      const std::uint32_t own = place[start.segment];
      if (own == kNone || !(start.p < start.far)) continue;
      const Stroke& s = strokes[own];
      const auto compare = [&](const PlacedEnd& end) {
        const std::uint32_t other = place[end.segment];
        if (other == kNone || other == own) return;
        const Stroke& t = strokes[other];
        if (!(s.needs_overlap_check || t.needs_overlap_check)) return;
        if (!overlap(s.from, s.to, t.from, t.to, tolerance_)) return;
        found[task].push_back({std::max(own, other), std::min(own, other)});
      };
      const DirectedSegment segment{s.from, s.to};
      for (const SegmentEnds& group : compared.is_new(own) ? all : new_ones) group.for_each_along(segment, compare);
    }
  });
  std::vector<StrokePair> pairs;
  for (const std::vector<StrokePair>& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  parallel_sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace ligne
