#include "drawing/graphs/stroke_chains.hpp"

#include <cmath>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "drawing/graphs/stroke_nodes.hpp"

namespace ligne {

/// Coordinates are of at most 27 bits, so that nothing overflows.
double page_length(const Stroke& s) {
  const double dx = double(s.to.x) - s.from.x, dy = double(s.to.y) - s.from.y;
  return std::sqrt(dx * dx + dy * dy);
}

StrokeChains::StrokeChains(const std::vector<Stroke>& strokes) : chain_of_(strokes.size()), free_(strokes.size(), 0) {
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (is_seen(strokes[i])) seen_.push_back(i);
  }
  std::vector<std::uint32_t> next(2 * seen_.size(), kNone);  // per end of what is seen: the only other end at its place
  std::vector<std::uint8_t> alone(2 * seen_.size(), 0);
  for_each_node(strokes, seen_, [&](std::span<const StrokeEnd> ends) {
    if (ends.size() == 1) alone[ends[0].end] = 1;
    if (ends.size() == 2) next[ends[0].end] = ends[1].end;
  });
  DisjointSets sets(strokes.size());
  for (std::size_t end = 0; end < next.size(); ++end) {
    if (next[end] != kNone) sets.join(seen_[end / 2], seen_[next[end] / 2]);
  }
  chains_.resize(strokes.size());
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    const std::uint32_t i = seen_[k];
    const Stroke& s = strokes[i];
    chain_of_[i] = sets.find(i);
    Chain& chain = chains_[chain_of_[i]];
    chain.length += page_length(s);
    const bool from_free = alone[2 * k] != 0, to_free = alone[2 * k + 1] != 0;
    free_[i] = static_cast<std::uint8_t>(from_free | to_free << 1);
    chain.free_ends = static_cast<std::uint8_t>(chain.free_ends + from_free + to_free);
    chain.cut_ends = static_cast<std::uint8_t>(chain.cut_ends + (from_free && s.t_from > 0) + (to_free && s.t_to < 1));
  }
}

}  // namespace ligne
