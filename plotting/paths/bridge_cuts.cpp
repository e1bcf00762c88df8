#include "plotting/paths/bridge_cuts.hpp"

#include <algorithm>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "linework/map/nodes.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// A gap in a line between two parts that stay. Pieces [first, last) would fill it.
struct Gap {
  std::uint32_t first = 0, last = 0;
  double length = 0;  ///< lattice steps
};

/// The gaps of all lines, and the strokes that would fill them.
class GapFinder {
 public:
  GapFinder(std::span<const Stroke> whole, std::span<const Stroke> left) : whole_(whole), left_(left) {}

  void find(std::uint32_t first, std::uint32_t last);

  std::vector<Gap> gaps;
  std::vector<Stroke> pieces;

 private:
  void missing(const Stroke& segment, double t_from, LatticePoint from, double t_to, LatticePoint to) {
    Stroke piece = segment;
    piece.t_from = t_from;
    piece.from = from;
    piece.t_to = t_to;
    piece.to = to;
    pieces.push_back(piece);
  }

  std::span<const Stroke> whole_, left_;
  std::size_t at_ = 0;  ///< next stroke in left_
};

/// Finds the gaps of one line, whose segments are [first, last). A gap across the first point of a closed line is one
/// gap.
void GapFinder::find(std::uint32_t first, std::uint32_t last) {
  const auto base = static_cast<std::uint32_t>(pieces.size());
  std::vector<std::uint32_t> cuts;  // per part that stays: number of missing pieces before it
  for (std::uint32_t s = first; s < last; ++s) {
    const Stroke& segment = whole_[s];
    double t = segment.t_from;
    LatticePoint here = segment.from;
    for (; at_ < left_.size() && left_[at_].source == segment.source; ++at_) {
      const Stroke& stays = left_[at_];
      if (stays.t_from > t) missing(segment, t, here, stays.t_from, stays.from);
      cuts.push_back(static_cast<std::uint32_t>(pieces.size()));
      t = stays.t_to;
      here = stays.to;
    }
    if (t < segment.t_to) missing(segment, t, here, segment.t_to, segment.to);
  }
  const auto end = static_cast<std::uint32_t>(pieces.size());
  if (cuts.empty()) {
    pieces.resize(base);  // no part of the line stays
    return;
  }
  std::vector<Stroke> kept;
  const auto add = [&](std::uint32_t from, std::uint32_t to) {
    if (from == to) return;
    Gap gap{base + static_cast<std::uint32_t>(kept.size()), 0, 0};
    for (std::uint32_t i = from; i != to; ++i) {
      kept.push_back(pieces[i]);
      gap.length += page_length(pieces[i]);
    }
    gap.last = base + static_cast<std::uint32_t>(kept.size());
    gaps.push_back(gap);
  };
  for (std::size_t i = 1; i < cuts.size(); ++i) add(cuts[i - 1], cuts[i]);
  if (whole_[first].from == whole_[last - 1].to && (cuts.back() != end || cuts.front() != base)) {
    std::rotate(pieces.begin() + base, pieces.begin() + cuts.back(), pieces.begin() + end);
    add(base, base + (end - cuts.back()) + (cuts.front() - base));
  }
  pieces.resize(base);
  pieces.insert(pieces.end(), kept.begin(), kept.end());
}

/// The connected components of strokes, and whether an odd number of strokes meets at each node.
class Parities {
 public:
  /// Nodes are those of all strokes, but only the first `count` strokes are connected at first.
  Parities(const std::vector<Stroke>& strokes, std::uint32_t count)
      : nodes_(strokes), sets_(nodes_.end_count()), is_odd_(nodes_.end_count(), 0), odd_nodes_(nodes_.end_count(), 0) {
    for (std::uint32_t i = 0; i < count; ++i) connect(i);
  }

  void connect(std::uint32_t stroke) {
    std::uint32_t a = nodes_.of(2 * stroke), b = nodes_.of(2 * stroke + 1);
    if (a == b) return;
    for (const std::uint32_t n : {a, b}) {
      is_odd_[n] ^= 1;
      odd_nodes_[sets_.find(n)] += is_odd_[n] ? 1 : -1;
    }
    a = sets_.find(a);
    b = sets_.find(b);
    if (a == b) return;
    sets_.join(a, b);
    odd_nodes_[sets_.find(a)] = odd_nodes_[a] + odd_nodes_[b];
  }
  /// Whether a line between the nodes of two ends saves a lift of the pen.
  bool spares(std::uint32_t from_end, std::uint32_t to_end) {
    const std::uint32_t a = nodes_.of(from_end), b = nodes_.of(to_end);
    if (a == b || !is_odd_[a] || !is_odd_[b]) return false;
    return sets_.find(a) != sets_.find(b) || odd_nodes_[sets_.find(a)] > 2;
  }

 private:
  Nodes nodes_;
  DisjointSets sets_;                    ///< sets of nodes
  std::vector<std::uint8_t> is_odd_;     ///< by node
  std::vector<std::int32_t> odd_nodes_;  ///< by set: number of odd nodes
};

}  // namespace

bool bridge_cuts(std::span<const Stroke> whole, std::span<const std::uint32_t> line_begin, double lift_mm,
                 StrokeModel& model) {
  GapFinder finder(whole, model.strokes);
  for (std::size_t i = 0; i + 1 < line_begin.size(); ++i) {
    if (line_begin[i] < line_begin[i + 1]) finder.find(line_begin[i], line_begin[i + 1]);
  }
  const double most = lift_mm / model.lattice.step_mm;
  std::erase_if(finder.gaps, [&](const Gap& gap) { return !(gap.length < most); });
  if (finder.gaps.empty()) return false;
  std::stable_sort(finder.gaps.begin(), finder.gaps.end(), [](const Gap& a, const Gap& b) { return a.length < b.length; });
  const auto count = static_cast<std::uint32_t>(model.strokes.size());
  std::vector<Stroke> all = model.strokes;
  all.insert(all.end(), finder.pieces.begin(), finder.pieces.end());
  Parities parities(all, count);
  for (const Gap& gap : finder.gaps) {
    const std::uint32_t first = count + gap.first, last = count + gap.last;
    if (!parities.spares(2 * first, 2 * last - 1)) continue;
    for (std::uint32_t i = first; i < last; ++i) {
      parities.connect(i);
      model.strokes.push_back(all[i]);
    }
  }
  return model.strokes.size() > count;
}

}  // namespace ligne
