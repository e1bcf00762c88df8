#include "plotting/paths/bridge_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace ligne {
namespace {

/// A gap in a line between two parts that stay. Pieces [first, last) would fill it.
struct Gap {
  std::uint32_t first = 0, last = 0;
  double length = 0;  ///< lattice steps
};

double length_of(const Stroke& s) {
  return std::hypot(static_cast<double>(s.to.x - s.from.x), static_cast<double>(s.to.y - s.from.y));
}

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
      gap.length += length_of(pieces[i]);
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

/// Points where strokes end, their connected components, and whether an odd number of strokes meets in each.
class Nodes {
 public:
  Nodes(std::span<const Stroke> strokes, std::span<const Stroke> pieces) {
    for (const auto list : {strokes, pieces}) {
      for (const Stroke& s : list) points_.insert(points_.end(), {s.from, s.to});
    }
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    parent_.resize(points_.size());
    for (std::uint32_t n = 0; n < parent_.size(); ++n) parent_[n] = n;
    odd_.assign(points_.size(), 0);
    odd_ends_.assign(points_.size(), 0);
    for (const Stroke& s : strokes) add(node(s.from), node(s.to));
  }

  std::uint32_t node(LatticePoint p) const {
    return static_cast<std::uint32_t>(std::lower_bound(points_.begin(), points_.end(), p) - points_.begin());
  }
  void add(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    for (const std::uint32_t n : {a, b}) {
      odd_[n] ^= 1;
      odd_ends_[set_of(n)] += odd_[n] ? 1 : -1;
    }
    a = set_of(a);
    b = set_of(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    odd_ends_[std::min(a, b)] += odd_ends_[std::max(a, b)];
  }
  /// Whether a stroke between the two nodes saves a lift of the pen.
  bool spares(std::uint32_t a, std::uint32_t b) {
    if (a == b || !odd_[a] || !odd_[b]) return false;
    return set_of(a) != set_of(b) || odd_ends_[set_of(a)] > 2;
  }

 private:
  std::uint32_t set_of(std::uint32_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }

  std::vector<LatticePoint> points_;
  std::vector<std::uint32_t> parent_;
  std::vector<char> odd_;
  std::vector<std::int32_t> odd_ends_;  ///< number of odd nodes of a component, at its first node
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
  Nodes nodes(model.strokes, finder.pieces);
  bool any = false;
  for (const Gap& gap : finder.gaps) {
    const auto pieces = std::span(finder.pieces).subspan(gap.first, gap.last - gap.first);
    if (!nodes.spares(nodes.node(pieces.front().from), nodes.node(pieces.back().to))) continue;
    for (const Stroke& piece : pieces) {
      nodes.add(nodes.node(piece.from), nodes.node(piece.to));
      model.strokes.push_back(piece);
    }
    any = true;
  }
  return any;
}

}  // namespace ligne
