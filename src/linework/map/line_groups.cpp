#include "linework/map/line_groups.hpp"

#include <algorithm>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "linework/map/continuations.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Adjustable: number of ends that one task pairs.
constexpr std::size_t kPairedBlock = 16'384;

/// Pairs the ends of each class at a node, and then the ends without a partner.
void pair_ends(const LineMap& map, std::uint32_t node, std::vector<std::uint32_t>& same, std::vector<std::uint32_t>& other) {
  const Nodes& nodes = map.nodes();
  if (nodes.degree(node) == 1) return;
  const std::uint32_t first = nodes.first(node), second = nodes.other(first);
  if (second != kNone) {  // the only pair
    const Stroke &s = map.piece(first / 2), &t = map.piece(second / 2);
    if (!is_edge(s) || !is_edge(t)) return;
    return join_ends(s.line_class == t.line_class ? same : other, first, second);
  }
  std::vector<NodeArm> arms, group;  // those of the edges, in the order of their ends
  nodes.for_each_end(node, [&](std::uint32_t end) {
    if (is_edge(map.piece(end / 2))) arms.push_back(arm_from(map.point(end), map.point(end ^ 1), end));
  });
  for (std::size_t c = 0; c < kEdgeClassCount; ++c) {
    group.clear();
    for (const NodeArm& arm : arms) {
      if (map.piece(arm.end / 2).line_class == static_cast<LineClass>(c)) group.push_back(arm);
    }
    pair_arms(group, same);
  }
  std::erase_if(arms, [&](const NodeArm& arm) { return same[arm.end] != kNone; });
  pair_arms(arms, other);
}

/// The ends at which the pieces of a line begin, from an end on: next(e) continues end e. Empty if it is longer than `most`.
template <class Next>
std::vector<std::uint32_t> ends_from(const LineMap& map, std::uint32_t end, double most, const Next& next) {
  constexpr double kLengthRounding = 1 + 0x1p-20;  // factor above the rounding errors of a sum of lengths
  std::vector<std::uint32_t> ends;
  for (double length = 0; end != kNone; end = next(end ^ 1)) {
    ends.push_back(end);
    length += page_length(map.piece(end / 2));
    if (length > kLengthRounding * most) return {};
  }
  return ends;
}

/// A line without its junctions. Lengths are added in the order of the pieces, so that both of its ends give the same sum.
Arcs::Arc line_of(const LineMap& map, std::span<const std::uint32_t> ends) {
  Arcs::Arc line;
  line.ends.assign(ends.begin(), ends.end());
  line.pieces.reserve(ends.size());
  for (const std::uint32_t end : ends) line.pieces.push_back(end / 2);
  std::ranges::sort(line.pieces);
  for (const std::uint32_t p : line.pieces) line.length += page_length(map.piece(p));
  return line;
}

}  // namespace

Runs::Runs(const LineMap& map) : of_(map.piece_count(), kNone), runs_(map.piece_count()) {
  const std::size_t ends = 2 * std::size_t{map.piece_count()};
  std::vector<std::uint32_t> same(ends, kNone), other = same;
  parallel_blocks(ends, kPairedBlock, [&](std::size_t begin, std::size_t last) {
    for (auto end = static_cast<std::uint32_t>(begin); end < last; ++end) {
      const bool is_first = map.is_alive(end / 2) && map.nodes().first(map.nodes().of(end)) == end;
      if (is_first) pair_ends(map, map.nodes().of(end), same, other);
    }
  });
  DisjointSets sets(map.piece_count());
  for (std::uint32_t end = 0; end < ends; ++end) {
    if (same[end] != kNone) sets.join(end / 2, same[end] / 2);
  }
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    if (!map.is_alive(p) || !is_edge(map.piece(p))) continue;
    of_[p] = sets.find(p);
    runs_[of_[p]].length += page_length(map.piece(p));
    runs_[of_[p]].line_class = map.piece(p).line_class;
  }
  for (std::uint32_t end = 0; end < ends; ++end) {
    if (other[end] == kNone) continue;
    const std::uint32_t beside = of_[other[end] / 2];
    Run& run = runs_[of_[end / 2]];
    if (runs_[beside].line_class == run.line_class) continue;
    if (run.longest_continuation == kNone || runs_[beside].length > runs_[run.longest_continuation].length)
      run.longest_continuation = beside;
  }
}

Arcs::Arcs(const LineMap& map, double reach)
    : map_(map), junction_of_(2 * std::size_t{map.piece_count()}), is_left_(map.piece_count(), 0) {
  const std::uint32_t ends = 2 * map.piece_count();
  DisjointSets junctions(ends);
  for (const Contact& contact : map.contacts()) {
    if (map.holds(contact) && contact.distance <= reach) junctions.join(contact.node, contact.other);
  }
  degree_.assign(ends, 0);
  for (std::uint32_t end = 0; end < ends; ++end) junction_of_[end] = junctions.find(map.nodes().of(end));
  for (std::uint32_t p = 0; p < map.piece_count(); ++p) {
    is_left_[p] = map.is_alive(p) && junction_of_[2 * p] != junction_of_[2 * p + 1];
    if (is_left_[p]) ++degree_[junction_of_[2 * p]], ++degree_[junction_of_[2 * p + 1]];
  }
  at_junction_ = {ends, [&](const auto& put) {
                    for (std::uint32_t end = 0; end < ends; ++end) {
                      if (is_left_[end / 2]) put(junction_of_[end], end);
                    }
                  }};
}

std::uint32_t Arcs::next(std::uint32_t end) const {
  const std::uint32_t junction = junction_of_[end];
  if (degree_[junction] != 2) return kNone;
  return *std::ranges::find_if(ends_at(junction), [&](std::uint32_t e) { return has(e / 2) && e != end; });
}

Arcs::Arc Arcs::arc_of(std::span<const std::uint32_t> ends, bool is_ring) const {
  Arc arc = line_of(map_, ends);
  if (!is_ring) arc.junctions = {junction_of_[ends.front()], junction_of_[ends.back() ^ 1]};
  return arc;
}

std::vector<Arcs::Arc> Arcs::find() const {
  std::vector<std::uint32_t> partner(junction_of_.size(), kNone);
  for (std::uint32_t end = 0; end < partner.size(); ++end) {
    if (has(end / 2)) partner[end] = next(end);
  }
  std::vector<Arc> found;
  for_each_line(partner, LineOrder::strokes, [&](std::span<const std::uint32_t> ends, bool is_ring) {
    if (has(ends.front() / 2)) found.push_back(arc_of(ends, is_ring));
  });
  return found;
}

Arcs::Arc Arcs::from(std::uint32_t end, double most) const {
  const std::vector<std::uint32_t> ends = ends_from(map_, end, most, [&](std::uint32_t e) { return next(e); });
  return ends.empty() ? Arc{} : arc_of(ends, false);
}

void Arcs::take_away(const Arc& arc) {
  for (const std::uint32_t p : arc.pieces) {
    is_left_[p] = 0;
    --degree_[junction_of_[2 * p]];
    --degree_[junction_of_[2 * p + 1]];
  }
}

Arcs::Arc chain_from(const LineMap& map, std::uint32_t free_end, double most) {
  return line_of(map, ends_from(map, free_end, most, [&](std::uint32_t e) { return map.next(e); }));
}

}  // namespace ligne
