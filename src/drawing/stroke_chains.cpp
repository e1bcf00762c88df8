#include "drawing/stroke_chains.hpp"

#include <cmath>

#include "geometry/disjoint_sets.hpp"

namespace ligne {

double page_length(const Stroke& s) { return std::hypot(double(s.to.x) - s.from.x, double(s.to.y) - s.from.y); }

StrokeChains::StrokeChains(const std::vector<Stroke>& strokes) : chain_of_(strokes.size()) {
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (!is_seen(strokes[i])) continue;
    seen_.push_back(i);
    for (const LatticePoint p : {strokes[i].from, strokes[i].to}) {
      std::uint32_t& at = table_[KeyTable::key(p)];
      if (at == KeyTable::kNone) {
        at = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
      }
      Node& node = nodes_[at];
      (node.count == 0 ? node.first : node.second) = i;
      ++node.count;
    }
  }
  DisjointSets sets(strokes.size());
  for (const Node& node : nodes_) {
    if (node.count == 2) sets.join(node.first, node.second);
  }
  chains_.resize(strokes.size());
  for (const std::uint32_t i : seen_) {
    const Stroke& s = strokes[i];
    chain_of_[i] = sets.find(i);
    Chain& chain = chains_[chain_of_[i]];
    chain.length += page_length(s);
    const bool from_free = is_free(s.from), to_free = is_free(s.to);
    chain.free_ends = static_cast<std::uint8_t>(chain.free_ends + from_free + to_free);
    chain.cut_ends = static_cast<std::uint8_t>(chain.cut_ends + (from_free && s.t_from > 0) + (to_free && s.t_to < 1));
  }
}

}  // namespace ligne
