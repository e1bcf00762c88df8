/// Joins strokes in five steps:
///
/// 1. Snaps all points to a lattice far finer than any plotter, so that the equality of points is exact.
/// 2. Simplifies with a quarter of the tolerance, except at points that lines share. The segments of a curve become
/// long enough to detect that two of them coincide.
/// 3. Removes coincident segments (remove_coincident_strokes).
/// 4. Pairs ends at one lattice point, the straightest first, the rest in their order. This makes chains and rings. A
/// ring R that touches another chain C in a node is inserted into it: the pairs (r1, r2) and (c1, c2) become (c1, r1)
/// and (r2, c2), whichever way the two run.
/// 5. Joins loose ends of chains within the tolerance, nearest first, and simplifies the result with the rest of the
/// tolerance.

#include "plotting/paths/optimize.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/key_table.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "geometry/search/nearest_points.hpp"
#include "geometry/simplify.hpp"
#include "linework/map/continuations.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {
namespace {

/// Fraction of the tolerances of simplification that is spent before overlaps are searched.
constexpr double kEarlyPart = 0.25;

/// Polylines on the lattice without repeated points. Lines without length go to `dots`.
struct LatticeLines {
  Lattice lattice;
  std::vector<LatticePoint> points;
  std::vector<std::uint32_t> begin{0};
  std::vector<LatticePoint> dots;
};

LatticeLines on_lattice(const Polylines& lines) {
  LatticeLines out;
  Rect bounds;
  for (const Point2 p : lines.points) bounds.extend(p);
  out.lattice = Lattice::covering(bounds);
  out.points.reserve(lines.points.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t first = out.points.size();
    for (const Point2 mm : lines[i]) {
      const LatticePoint p = out.lattice.snap(mm);
      if (out.points.size() == first || out.points.back() != p) out.points.push_back(p);
    }
    if (out.points.size() == first + 1) {
      out.dots.push_back(out.points.back());
      out.points.pop_back();
    } else if (out.points.size() > first) {
      out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
    }
  }
  std::sort(out.dots.begin(), out.dots.end());
  out.dots.erase(std::unique(out.dots.begin(), out.dots.end()), out.dots.end());
  return out;
}

/// Per point: 1 if another point lies on the same lattice point.
std::vector<char> shared_points(const LatticeLines& lines) {
  std::vector<char> shared(lines.points.size(), 0);
  KeyTable first_at;
  for (std::uint32_t i = 0; i < shared.size(); ++i) {
    std::uint32_t& first = first_at[KeyTable::key(lines.points[i])];
    if (first == kNone) first = i;
    shared[i] = shared[first] = first != i;
  }
  return shared;
}

/// The segments of the lines as strokes of a model, numbered by source in order.
StrokeModel segments_of(const LatticeLines& lines, double tolerance_mm, double most_lost) {
  StrokeModel model;
  model.lattice = lines.lattice;
  const std::vector<char> shared = tolerance_mm > 0 ? shared_points(lines) : std::vector<char>(lines.points.size(), 1);
  std::vector<Point2> line_mm;
  for (std::size_t i = 0; i + 1 < lines.begin.size(); ++i) {
    const std::size_t first = lines.begin[i], count = lines.begin[i + 1] - first;
    line_mm.clear();
    for (std::size_t k = 0; k < count; ++k) line_mm.push_back(lines.lattice.to_mm(lines.points[first + k]));
    for (std::size_t from = 0, to = 1; to < count; ++to) {
      if (to + 1 < count && !shared[first + to]) continue;
      const auto kept = simplified(std::span(line_mm).subspan(from, to - from + 1), tolerance_mm, most_lost);
      for (std::size_t k = 1; k < kept.size(); ++k) {
        Stroke stroke{.from = lines.points[first + from + kept[k - 1]],
                      .to = lines.points[first + from + kept[k]],
                      .source = static_cast<std::uint32_t>(model.strokes.size())};
        if (stroke.from != stroke.to) model.strokes.push_back(stroke);
      }
      from = to;
    }
  }
  model.edge_count = static_cast<std::uint32_t>(model.strokes.size());
  return model;
}

/// Keeps one of the segments between the same two points, however short: remove_coincident_strokes() finds only
/// overlaps longer than the tolerance.
void remove_equal(std::vector<Stroke>& strokes) {
  const Nodes nodes(strokes);
  KeyTable met;  // pairs of nodes
  std::uint32_t end = 0;
  std::erase_if(strokes, [&](const Stroke&) {
    const auto a = static_cast<std::int32_t>(nodes.of(end)), b = static_cast<std::int32_t>(nodes.of(end + 1));
    end += 2;
    return std::exchange(met[KeyTable::key(std::min(a, b), std::max(a, b))], 0) != kNone;
  });
}

/// The lines that strokes make: the partner of each end, and the chains.
class JoinedStrokes {
 public:
  explicit JoinedStrokes(const StrokeModel& model)
      : model_(model),
        strokes_(model.strokes),
        nodes_(strokes_),
        partner_(nodes_.end_count(), kNone),
        chain_of_(strokes_.size()),
        is_ring_(strokes_.size(), 1) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t end = 0; end < nodes_.end_count(); ++end) {
      if (nodes_.first(nodes_.of(end)) == end) order.push_back(end);
    }
    std::ranges::sort(order, {}, [&](std::uint32_t node) { return point(node); });
    for (const std::uint32_t node : order) pair_ends(node);
    for (std::uint32_t end = 0; end < partner_.size(); ++end) {
      if (partner_[end] != kNone) chain_of_.join(end / 2, partner_[end] / 2);
    }
    for (std::uint32_t end = 0; end < partner_.size(); ++end) {
      if (partner_[end] == kNone) is_ring_[chain_of_.find(end / 2)] = 0;
    }
    for (const std::uint32_t node : order) take_in_rings(node);
  }

  Polylines polylines() const {
    Polylines out;
    out.points.reserve(strokes_.size() + strokes_.size() / 8);
    for_each_line(partner_, LineOrder::strokes, [&](std::span<const std::uint32_t> ends, bool) {
      out.points.push_back(model_.lattice.to_mm(point(ends.front())));
      for (const std::uint32_t end : ends) out.points.push_back(model_.lattice.to_mm(point(end ^ 1)));
      out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
    });
    return out;
  }

 private:
  LatticePoint point(std::uint32_t end) const { return tip(strokes_[end / 2], end).p; }

  /// Pairs the straightest ends at a node, then the rest in their order.
  void pair_ends(std::uint32_t node) {
    std::vector<NodeArm> arms;
    nodes_.for_each_end(node, [&](std::uint32_t e) { arms.push_back(arm_from(point(e), point(e ^ 1), e)); });
    pair_arms(arms, partner_);
    std::uint32_t waiting = kNone;
    nodes_.for_each_end(node, [&](std::uint32_t e) {
      if (partner_[e] != kNone) return;
      if (waiting != kNone) join_ends(partner_, e, waiting);
      waiting = waiting == kNone ? e : kNone;
    });
  }

  void take_in_rings(std::uint32_t node) {
    std::uint32_t base = kNone;
    nodes_.for_each_end(node, [&](std::uint32_t e) {
      if (partner_[e] == kNone) return;
      if (base == kNone) {
        base = e;
        return;
      }
      const std::uint32_t a = chain_of_.find(base / 2), b = chain_of_.find(e / 2);
      if (a == b || !(is_ring_[a] || is_ring_[b])) return;
      join_ends(partner_, partner_[base], partner_[e]);
      join_ends(partner_, base, e);
      chain_of_.join(a, b);
      is_ring_[chain_of_.find(a)] = is_ring_[a] && is_ring_[b];
    });
    if (base != kNone) lengthen_by_ring(node, base);
  }

  /// Continues a chain that ends on a ring around the ring.
  void lengthen_by_ring(std::uint32_t node, std::uint32_t pass) {
    const std::uint32_t ring = chain_of_.find(pass / 2);
    if (!is_ring_[ring]) return;
    std::uint32_t loose = kNone;
    nodes_.for_each_end(node, [&](std::uint32_t e) {
      if (loose == kNone && partner_[e] == kNone && chain_of_.find(e / 2) != ring) loose = e;
    });
    if (loose == kNone) return;
    partner_[partner_[pass]] = kNone;
    join_ends(partner_, pass, loose);
    chain_of_.join(ring, loose / 2);
    is_ring_[chain_of_.find(ring)] = 0;
  }

  const StrokeModel& model_;
  const std::vector<Stroke>& strokes_;
  Nodes nodes_;
  std::vector<std::uint32_t> partner_;  ///< by end
  DisjointSets chain_of_;               ///< sets of strokes
  std::vector<std::uint8_t> is_ring_;   ///< by chain
};

/// A line is closed over a gap only if it is longer than this multiple of the gap: it must go somewhere and come back.
constexpr double kLoopLengths = 4;

/// Nearest ends that are tried for each loose end. Adjustable.
constexpr std::size_t kCandidates = 8;

/// The square of the distance of two loose ends, and the ends, the lower one first.
using Pair = std::tuple<double, std::uint32_t, std::uint32_t>;

/// Pairs of loose ends within the tolerance, the nearest first. End 2 i is the first point of line i, end 2 i + 1 its
/// last.
std::vector<Pair> near_pairs(const Polylines& lines, double tolerance_mm) {
  std::vector<std::uint32_t> ends;
  std::vector<Point2> points;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (is_loop(lines[i])) continue;
    for (const bool last : {false, true}) {
      ends.push_back(2 * i + last);
      points.push_back(last ? lines[i].back() : lines[i].front());
    }
  }
  const NearestPoints tree(points);
  std::vector<std::vector<Pair>> found(ends.size());
  parallel_blocks(ends.size(), kSearchBlock, [&](std::size_t first, std::size_t last) {
    std::vector<NearestPoints::Neighbour> neighbours;
    for (std::size_t e = first; e < last; ++e) {
      tree.nearest(points[e], kCandidates + 1, neighbours);
      for (const NearestPoints::Neighbour& n : neighbours) {
        if (n.squared > tolerance_mm * tolerance_mm) break;
        if (n.point != e)
          found[e].emplace_back(n.squared, std::min(ends[e], ends[n.point]), std::max(ends[e], ends[n.point]));
      }
    }
  });
  std::vector<Pair> pairs;
  for (const std::vector<Pair>& of_end : found) pairs.insert(pairs.end(), of_end.begin(), of_end.end());
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace

Polylines join_near_ends(const Polylines& lines, double tolerance_mm) {
  if (!(tolerance_mm > 0)) return lines;
  std::vector<std::uint32_t> partner(2 * lines.size(), kNone);
  for (const auto& [squared, a, b] : near_pairs(lines, tolerance_mm)) {
    if (partner[a] != kNone || partner[b] != kNone) continue;
    if (a / 2 == b / 2 && path_length(lines[a / 2]) <= kLoopLengths * std::sqrt(squared)) continue;
    join_ends(partner, a, b);
  }

  Polylines out;
  for_each_line(partner, LineOrder::strokes, [&](std::span<const std::uint32_t> ends, bool is_ring) {
    const std::size_t first = out.points.size();
    for (const std::uint32_t end : ends) {
      const auto line = lines[end / 2];
      const auto add = [&](Point2 p) {
        if (out.points.size() == first || out.points.back() != p) out.points.push_back(p);
      };
      if (end % 2 == 0) {
        std::for_each(line.begin(), line.end(), add);
      } else {
        std::for_each(line.rbegin(), line.rend(), add);
      }
    }
    if (is_ring && out.points.back() != out.points[first]) out.points.push_back(out.points[first]);
    out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  });
  return out;
}

Polylines join_strokes(const Polylines& lines, const JoinTolerances& tolerances) {
  const LatticeLines snapped = on_lattice(lines);
  const bool once = tolerances.overlap_mm > 0;
  const double early = once ? kEarlyPart * tolerances.simplify_mm : 0;
  const double early_loss = once ? kEarlyPart * tolerances.simplify_loss : 0;
  StrokeModel model = segments_of(snapped, early, early_loss);
  if (once) {
    remove_equal(model.strokes);
    remove_coincident_strokes(model, tolerances.overlap_mm);
    std::ranges::sort(model.strokes, {}, [](const Stroke& s) { return std::tuple(s.source, s.t_from); });
  }
  const Polylines joined = join_near_ends(JoinedStrokes(model).polylines(), tolerances.ends_mm);

  Polylines out;
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const auto kept = simplified(joined[i], tolerances.simplify_mm - early, tolerances.simplify_loss - early_loss);
    for (const std::uint32_t k : kept) out.points.push_back(joined[i][k]);
    out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  }
  for (const LatticePoint dot : snapped.dots) {
    out.points.insert(out.points.end(), 2, snapped.lattice.to_mm(dot));
    out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  }
  return out;
}

}  // namespace ligne
