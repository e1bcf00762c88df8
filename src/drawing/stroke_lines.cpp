#include "drawing/stroke_lines.hpp"

#include "drawing/key_table.hpp"
#include "drawing/node_pairs.hpp"
#include "drawing/stroke_chains.hpp"
#include "geometry/disjoint_sets.hpp"

namespace ligne {

/// Ends are numbered by the strokes that are seen: end 2 i is the `from` of seen_[i], end 2 i + 1 its `to`.
void StrokeLines::link(const std::vector<Stroke>& strokes, std::vector<std::uint32_t>& same,
                       std::vector<std::uint32_t>& other) const {
  const std::size_t n = 2 * seen_.size();
  KeyTable table;
  std::vector<std::uint32_t> node_of(n), begin{0};
  for (std::uint32_t end = 0; end < n; ++end) {
    const Stroke& s = strokes[seen_[end / 2]];
    std::uint32_t& node = table[KeyTable::key(end % 2 == 0 ? s.from : s.to)];
    if (node == KeyTable::kNone) {
      node = static_cast<std::uint32_t>(begin.size() - 1);
      begin.push_back(0);
    }
    node_of[end] = node;
    ++begin[node + 1];
  }
  for (std::size_t node = 0; node + 1 < begin.size(); ++node) begin[node + 1] += begin[node];
  std::vector<NodeArm> arms(n), group;
  std::vector<std::uint32_t> cursor(begin.begin(), begin.end() - 1);
  for (std::uint32_t end = 0; end < n; ++end) {
    const Stroke& s = strokes[seen_[end / 2]];
    const LatticePoint at = end % 2 == 0 ? s.from : s.to, far = end % 2 == 0 ? s.to : s.from;
    arms[cursor[node_of[end]]++] = {{far.x - at.x, far.y - at.y}, end};
  }
  const auto class_of = [&](const NodeArm& arm) { return strokes[seen_[arm.end / 2]].line_class; };
  for (std::size_t node = 0; node + 1 < begin.size(); ++node) {
    const std::span<const NodeArm> here{arms.data() + begin[node], arms.data() + begin[node + 1]};
    if (here.size() < 2) continue;
    for (std::size_t c = 0; c < kEdgeClassCount; ++c) {
      group.clear();
      for (const NodeArm& arm : here) {
        if (class_of(arm) == static_cast<LineClass>(c)) group.push_back(arm);
      }
      pair_arms(group, same);
    }
    group.clear();
    for (const NodeArm& arm : here) {
      if (same[arm.end] == kNoPartner) group.push_back(arm);
    }
    pair_arms(group, other);
  }
}

StrokeLines::StrokeLines(const std::vector<Stroke>& strokes) : run_of_(strokes.size(), kNone), runs_(strokes.size()) {
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (is_seen(strokes[i]) && is_edge(strokes[i]) && strokes[i].from != strokes[i].to) seen_.push_back(i);
  }
  std::vector<std::uint32_t> same(2 * seen_.size(), kNoPartner), other = same;
  link(strokes, same, other);
  DisjointSets sets(strokes.size());
  for (std::uint32_t end = 0; end < same.size(); ++end) {
    if (same[end] != kNoPartner) sets.join(seen_[end / 2], seen_[same[end] / 2]);
  }
  for (const std::uint32_t i : seen_) {
    run_of_[i] = sets.find(i);
    Run& run = runs_[run_of_[i]];
    run.length += page_length(strokes[i]);
    run.line_class = strokes[i].line_class;
  }
  for (std::uint32_t end = 0; end < other.size(); ++end) {
    if (other[end] == kNoPartner) continue;
    const std::uint32_t beside = run_of_[seen_[other[end] / 2]];
    std::uint32_t& longest = runs_[run_of_[seen_[end / 2]]].longest_beside;
    if (runs_[beside].line_class == runs_[run_of_[seen_[end / 2]]].line_class) continue;
    if (longest == kNone || runs_[beside].length > runs_[longest].length) longest = beside;
  }
}

}  // namespace ligne
