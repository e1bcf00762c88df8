#include "drawing/graphs/stroke_lines.hpp"

#include <algorithm>
#include <span>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "drawing/graphs/stroke_chains.hpp"
#include "drawing/graphs/stroke_nodes.hpp"

namespace ligne {

/// Ends are numbered by the strokes that are seen: end 2 i is the `from` of seen_[i], end 2 i + 1 its `to`.
void StrokeLines::link(const std::vector<Stroke>& strokes, std::vector<std::uint32_t>& same,
                       std::vector<std::uint32_t>& other) const {
  const auto class_of = [&](const NodeArm& arm) { return strokes[seen_[arm.end / 2]].line_class; };
  for_each_node(strokes, seen_, [&](std::span<const StrokeEnd> ends) {
    if (ends.size() < 2) return;
    const NodeArms arms(strokes, seen_, ends);
    const std::span<const NodeArm> here = arms.all();
    if (std::ranges::all_of(here, [&](const NodeArm& arm) { return class_of(arm) == class_of(here[0]); })) {
      pair_arms(here, same);
      return;
    }
    NodeArms group;
    for (std::size_t c = 0; c < kEdgeClassCount; ++c) {
      group.clear();
      for (const NodeArm& arm : here) {
        if (class_of(arm) == static_cast<LineClass>(c)) group.add(arm);
      }
      pair_arms(group.all(), same);
    }
    group.clear();
    for (const NodeArm& arm : here) {
      if (same[arm.end] == kNone) group.add(arm);
    }
    pair_arms(group.all(), other);
  });
}

StrokeLines::StrokeLines(const std::vector<Stroke>& strokes) : run_of_(strokes.size(), kNone), runs_(strokes.size()) {
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (is_seen(strokes[i]) && is_edge(strokes[i]) && strokes[i].from != strokes[i].to) seen_.push_back(i);
  }
  std::vector<std::uint32_t> same(2 * seen_.size(), kNone), other = same;
  link(strokes, same, other);
  DisjointSets sets(strokes.size());
  for (std::uint32_t end = 0; end < same.size(); ++end) {
    if (same[end] != kNone) sets.join(seen_[end / 2], seen_[same[end] / 2]);
  }
  for (const std::uint32_t i : seen_) {
    run_of_[i] = sets.find(i);
    Run& run = runs_[run_of_[i]];
    run.length += page_length(strokes[i]);
    run.line_class = strokes[i].line_class;
  }
  for (std::uint32_t end = 0; end < other.size(); ++end) {
    if (other[end] == kNone) continue;
    const std::uint32_t beside = run_of_[seen_[other[end] / 2]];
    std::uint32_t& longest = runs_[run_of_[seen_[end / 2]]].longest_beside;
    if (runs_[beside].line_class == runs_[run_of_[seen_[end / 2]]].line_class) continue;
    if (longest == kNone || runs_[beside].length > runs_[longest].length) longest = beside;
  }
}

}  // namespace ligne
