#include "drawing/short_bits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include "drawing/key_table.hpp"
#include "geometry/disjoint_sets.hpp"

namespace ligne {
namespace {

bool is_seen(const Stroke& s) { return s.visible && s.level == 0; }

double page_length(LatticePoint a, LatticePoint b) { return std::hypot(double(b.x) - a.x, double(b.y) - a.y); }
double page_length(const Stroke& s) { return page_length(s.from, s.to); }

/// Of the scene's edges; lines of surfaces and axes are as they are.
bool is_edge(const Stroke& s) { return static_cast<std::size_t>(s.line_class) < kEdgeClassCount; }

bool any_hidden(const std::vector<Stroke>& strokes) {
  return std::any_of(strokes.begin(), strokes.end(), [](const Stroke& s) { return !s.visible; });
}

Stroke between(const Stroke& a, const Stroke& b) {
  Stroke gap = a;
  gap.t_from = a.t_to;
  gap.t_to = b.t_from;
  gap.from = a.to;
  gap.to = b.from;
  gap.z_from = a.z_to;
  gap.z_to = b.z_from;
  gap.w_from = a.w_to;
  gap.w_to = b.w_from;
  return gap;
}

/// Where visible strokes end.
class Ends {
 public:
  struct Node {
    std::uint32_t count = 0, first = 0, second = 0;  ///< strokes that end here
  };

  Ends(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& members) {
    for (const std::uint32_t i : members) {
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
  }

  const Node& at(LatticePoint p) const { return nodes_[table_.find(KeyTable::key(p))]; }

 private:
  KeyTable table_;
  std::vector<Node> nodes_;
};

/// Strokes that continue each other where no third one ends.
struct Chain {
  double length = 0;  ///< steps
  int free_ends = 0;  ///< at which no other stroke ends
  int cut_ends = 0;   ///< of those, where the source goes on
  bool edges_only = true;
};

}  // namespace

std::size_t close_short_gaps(StrokeModel& model, double gap_mm) {
  std::vector<Stroke>& strokes = model.strokes;
  const double longest = gap_mm / model.lattice.step_mm;
  const bool hidden_too = any_hidden(strokes);
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (is_edge(strokes[i])) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(strokes[a].source, strokes[a].t_from, a) < std::tie(strokes[b].source, strokes[b].t_from, b);
  });
  std::size_t closed = 0;
  std::vector<Stroke> added;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const Stroke& a = strokes[order[i]];
    if (!is_seen(a)) continue;
    std::size_t k = i + 1;
    while (k < order.size() && strokes[order[k]].source == a.source && !strokes[order[k]].visible) ++k;
    if (k == order.size()) break;
    const Stroke& b = strokes[order[k]];
    const double gap = page_length(a.to, b.from);
    if (b.source != a.source || !is_seen(b) || b.line_class != a.line_class || !(gap > 0) || gap >= longest) continue;
    if (hidden_too != (k > i + 1)) continue;  // a gap without hidden strokes among others: nothing is known of it
    ++closed;
    if (!hidden_too) added.push_back(between(a, b));
    for (std::size_t h = i + 1; h < k; ++h) {
      strokes[order[h]].visible = true;
      strokes[order[h]].level = 0;
    }
  }
  strokes.insert(strokes.end(), added.begin(), added.end());
  return closed;
}

std::size_t drop_short_bits(StrokeModel& model, double least_mm) {
  std::vector<Stroke>& strokes = model.strokes;
  const double least = least_mm / model.lattice.step_mm;
  std::vector<std::uint32_t> seen;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (is_seen(strokes[i])) seen.push_back(i);
  }
  const bool hidden_too = any_hidden(strokes);
  const Ends ends(strokes, seen);
  DisjointSets sets(strokes.size());
  for (const std::uint32_t i : seen) {
    for (const LatticePoint p : {strokes[i].from, strokes[i].to}) {
      if (const Ends::Node& node = ends.at(p); node.count == 2) sets.join(node.first, node.second);
    }
  }
  std::vector<Chain> chains(strokes.size());
  for (const std::uint32_t i : seen) {
    const Stroke& s = strokes[i];
    Chain& chain = chains[sets.find(i)];
    chain.length += page_length(s);
    chain.edges_only = chain.edges_only && is_edge(s);
    const bool from_free = ends.at(s.from).count == 1, to_free = ends.at(s.to).count == 1;
    chain.free_ends += from_free + to_free;
    chain.cut_ends += (from_free && s.t_from > 0) + (to_free && s.t_to < 1);
  }
  std::size_t dropped = 0;
  for (const std::uint32_t i : seen) {
    const std::uint32_t set = sets.find(i);
    const Chain& chain = chains[set];
    if (!chain.edges_only || chain.length >= least || chain.free_ends != 2 || chain.cut_ends == 0) continue;
    dropped += set == i;
    strokes[i].visible = false;
  }
  if (!hidden_too) std::erase_if(strokes, [](const Stroke& s) { return !s.visible; });
  return dropped;
}

}  // namespace ligne
