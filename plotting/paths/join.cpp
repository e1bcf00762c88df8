/// Joins strokes in five steps:
///
/// 1. Snaps all points to a lattice far finer than any plotter, so that the equality of points is exact.
/// 2. Simplifies with a quarter of the tolerance, except at points that lines share. The segments of a curve become
/// long enough to detect that two of them coincide.
/// 3. Removes coincident segments (remove_coincident_strokes), except where that only costs lifts (bridge_cuts). Before
/// this it compares lines as a whole if their segments are shorter than the tolerance (small_doubles).
/// 4. Pairs ends at one lattice point, the straightest first, the rest in their order. This makes chains and rings. A
/// ring R that touches another chain C in a node is inserted into it: the pairs (r1, r2) and (c1, c2) become (c1, r1)
/// and (r2, c2), whichever way the two run.
/// 5. Joins loose ends of chains within the tolerance, nearest first, and simplifies the result with the rest of the
/// tolerance.

#include "plotting/paths/join.hpp"
#include "linework/overlaps/coincident_strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "linework/node_pairs.hpp"
#include "plotting/paths/bridge_cuts.hpp"
#include "plotting/paths/chain_ends.hpp"
#include "plotting/paths/simplify.hpp"
#include "plotting/paths/small_doubles.hpp"

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
    if (out.points.size() == first) continue;
    if (out.points.size() == first + 1) {
      out.dots.push_back(out.points.back());
      out.points.pop_back();
    } else {
      out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
    }
  }
  std::sort(out.dots.begin(), out.dots.end());
  out.dots.erase(std::unique(out.dots.begin(), out.dots.end()), out.dots.end());
  return out;
}

/// Removes small lines that lie on others.
void remove_small_doubles(LatticeLines& lines, double tolerance_mm) {
  std::vector<Point2> places;
  places.reserve(lines.points.size());
  for (const LatticePoint p : lines.points) places.push_back(lines.lattice.to_mm(p));
  const std::vector<char> doubled = small_doubles(places, lines.begin, tolerance_mm);
  if (std::ranges::find(doubled, 1) == doubled.end()) return;
  std::vector<LatticePoint> points;
  std::vector<std::uint32_t> begin{0};
  for (std::size_t i = 0; i < doubled.size(); ++i) {
    if (doubled[i]) continue;
    points.insert(points.end(), lines.points.begin() + lines.begin[i], lines.points.begin() + lines.begin[i + 1]);
    begin.push_back(static_cast<std::uint32_t>(points.size()));
  }
  lines.points = std::move(points);
  lines.begin = std::move(begin);
}

/// Per point: 1 if another point lies on the same lattice point.
std::vector<char> shared_points(const LatticeLines& lines) {
  std::vector<std::uint32_t> order(lines.points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) { return lines.points[l] < lines.points[r]; });
  std::vector<char> shared(order.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (lines.points[order[i]] == lines.points[order[i - 1]]) shared[order[i]] = shared[order[i - 1]] = 1;
  }
  return shared;
}

/// The segments of the lines as strokes of a model, numbered by source in order. The strokes of line i begin at
/// line_begin[i].
StrokeModel segments_of(const LatticeLines& lines, double tolerance_mm, double most_lost,
                        std::vector<std::uint32_t>& line_begin) {
  StrokeModel model;
  model.lattice = lines.lattice;
  const std::vector<char> shared = tolerance_mm > 0 ? shared_points(lines) : std::vector<char>{};
  std::vector<Point2> piece;
  std::vector<std::uint32_t> where;
  const auto add_piece = [&] {
    const std::vector<std::uint32_t> kept = simplified(piece, tolerance_mm, most_lost);
    for (std::size_t k = 1; k < kept.size(); ++k) {
      Stroke stroke;
      stroke.from = lines.points[where[kept[k - 1]]];
      stroke.to = lines.points[where[kept[k]]];
      if (stroke.from == stroke.to) continue;
      stroke.source = static_cast<std::uint32_t>(model.strokes.size());
      model.strokes.push_back(stroke);
    }
  };
  for (std::size_t i = 0; i + 1 < lines.begin.size(); ++i) {
    piece.clear();
    where.clear();
    line_begin.push_back(static_cast<std::uint32_t>(model.strokes.size()));
    for (std::uint32_t j = lines.begin[i]; j < lines.begin[i + 1]; ++j) {
      piece.push_back(lines.lattice.to_mm(lines.points[j]));
      where.push_back(j);
      const bool last = j + 1 == lines.begin[i + 1];
      if (piece.size() > 1 && (last || shared.empty() || shared[j])) {
        add_piece();
        piece.assign(1, piece.back());
        where.assign(1, j);
      }
    }
  }
  line_begin.push_back(static_cast<std::uint32_t>(model.strokes.size()));
  model.edge_count = static_cast<std::uint32_t>(model.strokes.size());
  return model;
}

/// Keeps one of the segments between the same two points, however short: remove_coincident_strokes() finds only
/// overlaps longer than the tolerance.
void remove_equal(std::vector<Stroke>& strokes) {
  const auto key = [](const Stroke& s) {
    const auto [low, high] = s.to < s.from ? std::pair(s.to, s.from) : std::pair(s.from, s.to);
    return std::tuple(low.x, low.y, high.x, high.y);
  };
  std::sort(strokes.begin(), strokes.end(),
            [&](const Stroke& l, const Stroke& r) { return std::tuple(key(l), l.source) < std::tuple(key(r), r.source); });
  strokes.erase(
      std::unique(strokes.begin(), strokes.end(), [&](const Stroke& l, const Stroke& r) { return key(l) == key(r); }),
      strokes.end());
  std::sort(strokes.begin(), strokes.end(), [](const Stroke& l, const Stroke& r) { return l.source < r.source; });
}

/// Chains of strokes: end 2 i is the `from` of stroke i, end 2 i + 1 its `to`, partner[e] the end that continues e.
class Chains {
 public:
  explicit Chains(const StrokeModel& model) : model_(model), strokes_(model.strokes), partner_(2 * strokes_.size(), kNone) {
    find_nodes();
    pair_ends();
    number_chains();
    take_in_rings();
  }

  Polylines polylines() const;

 private:
  LatticePoint point(std::uint32_t end) const { return end % 2 == 0 ? strokes_[end / 2].from : strokes_[end / 2].to; }
  std::span<const std::uint32_t> node(std::size_t n) const {
    return {ends_.data() + node_begin_[n], ends_.data() + node_begin_[n + 1]};
  }
  std::size_t node_count() const { return node_begin_.size() - 1; }

  void find_nodes();
  void pair_ends();
  void number_chains();
  void take_in_rings();
  void lengthen_by_ring(std::span<const std::uint32_t> node, std::uint32_t pass);
  std::uint32_t set_of(std::uint32_t chain);

  const StrokeModel& model_;
  const std::vector<Stroke>& strokes_;
  std::vector<std::uint32_t> partner_;
  std::vector<std::uint32_t> ends_, node_begin_;
  std::vector<std::uint32_t> chain_of_, parent_;  ///< per stroke: its chain; per chain: its parent in union-find
  std::vector<char> ring_;
};

void Chains::find_nodes() {
  ends_.resize(partner_.size());
  for (std::uint32_t e = 0; e < ends_.size(); ++e) ends_[e] = e;
  std::sort(ends_.begin(), ends_.end(), [&](std::uint32_t l, std::uint32_t r) {
    const LatticePoint a = point(l), b = point(r);
    return std::tie(a.x, a.y, l) < std::tie(b.x, b.y, r);
  });
  for (std::uint32_t i = 0; i < ends_.size(); ++i) {
    if (i == 0 || point(ends_[i]) != point(ends_[i - 1])) node_begin_.push_back(i);
  }
  node_begin_.push_back(static_cast<std::uint32_t>(ends_.size()));
}

void Chains::pair_ends() {
  std::vector<NodeArm> arms;
  for (std::size_t n = 0; n < node_count(); ++n) {
    arms.clear();
    for (const std::uint32_t e : node(n)) {
      const LatticePoint here = point(e), there = point(e ^ 1);
      arms.push_back({{there.x - here.x, there.y - here.y}, e});
    }
    pair_arms(arms, partner_);
    std::uint32_t waiting = kNone;
    for (const std::uint32_t e : node(n)) {
      if (partner_[e] != kNone) continue;
      if (waiting == kNone) {
        waiting = e;
      } else {
        partner_[e] = waiting;
        partner_[waiting] = e;
        waiting = kNone;
      }
    }
  }
}

void Chains::number_chains() {
  chain_of_.assign(strokes_.size(), kNone);
  const auto follow = [&](std::uint32_t start) {
    const auto chain = static_cast<std::uint32_t>(ring_.size());
    std::uint32_t end = start;
    while (end != kNone && chain_of_[end / 2] == kNone) {
      chain_of_[end / 2] = chain;
      end = partner_[end ^ 1];
    }
    ring_.push_back(end != kNone);
    parent_.push_back(chain);
  };
  for (std::uint32_t end = 0; end < partner_.size(); ++end) {
    if (partner_[end] == kNone && chain_of_[end / 2] == kNone) follow(end);
  }
  for (std::uint32_t i = 0; i < strokes_.size(); ++i) {
    if (chain_of_[i] == kNone) follow(2 * i);
  }
}

std::uint32_t Chains::set_of(std::uint32_t chain) {
  while (parent_[chain] != chain) chain = parent_[chain] = parent_[parent_[chain]];
  return chain;
}

void Chains::take_in_rings() {
  for (std::size_t n = 0; n < node_count(); ++n) {
    std::uint32_t base = kNone;
    for (const std::uint32_t e : node(n)) {
      if (partner_[e] == kNone) continue;
      if (base == kNone) {
        base = e;
        continue;
      }
      const std::uint32_t a = set_of(chain_of_[base / 2]), b = set_of(chain_of_[e / 2]);
      if (a == b || !(ring_[a] || ring_[b])) continue;
      const std::uint32_t base_other = partner_[base], other = partner_[e];
      partner_[base] = e;
      partner_[e] = base;
      partner_[base_other] = other;
      partner_[other] = base_other;
      const std::uint32_t low = std::min(a, b), high = std::max(a, b);
      ring_[low] = ring_[a] && ring_[b];
      parent_[high] = low;
    }
    if (base != kNone) lengthen_by_ring(node(n), base);
  }
}

/// Continues a chain that ends on a ring around the ring.
void Chains::lengthen_by_ring(std::span<const std::uint32_t> node, std::uint32_t pass) {
  const std::uint32_t ring = set_of(chain_of_[pass / 2]);
  if (!ring_[ring]) return;
  for (const std::uint32_t e : node) {
    const std::uint32_t chain = set_of(chain_of_[e / 2]);
    if (partner_[e] != kNone || chain == ring) continue;
    partner_[partner_[pass]] = kNone;
    partner_[pass] = e;
    partner_[e] = pass;
    parent_[std::max(chain, ring)] = std::min(chain, ring);
    ring_[std::min(chain, ring)] = 0;
    return;
  }
}

Polylines Chains::polylines() const {
  Polylines out;
  out.points.reserve(strokes_.size() + strokes_.size() / 8);
  std::vector<char> walked(strokes_.size(), 0);
  for (std::uint32_t i = 0; i < strokes_.size(); ++i) {
    if (walked[i]) continue;
    // Back to where the chain begins; a ring begins here.
    std::uint32_t start = 2 * i;
    while (partner_[start] != kNone && (partner_[start] ^ 1) != 2 * i) start = partner_[start] ^ 1;
    if (partner_[start] != kNone) start = 2 * i;
    out.points.push_back(model_.lattice.to_mm(point(start)));
    for (std::uint32_t end = start; end != kNone && !walked[end / 2]; end = partner_[end ^ 1]) {
      walked[end / 2] = 1;
      out.points.push_back(model_.lattice.to_mm(point(end ^ 1)));
    }
    out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  }
  return out;
}

void append(Polylines& out, std::span<const Point2> line, std::span<const std::uint32_t> kept) {
  for (const std::uint32_t i : kept) out.points.push_back(line[i]);
  out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
}

}  // namespace

Polylines join_strokes(const Polylines& lines, const JoinTolerances& tolerances) {
  LatticeLines snapped = on_lattice(lines);
  const bool once = tolerances.overlap_mm > 0;
  if (once) remove_small_doubles(snapped, tolerances.overlap_mm);
  const double early = once ? kEarlyPart * tolerances.simplify_mm : 0;
  const double early_loss = once ? kEarlyPart * tolerances.simplify_loss : 0;
  std::vector<std::uint32_t> line_begin;
  StrokeModel model = segments_of(snapped, early, early_loss, line_begin);
  if (once) {
    const std::vector<Stroke> whole = model.strokes;
    remove_equal(model.strokes);
    remove_coincident_strokes(model, tolerances.overlap_mm);
    const auto by_place = [](const Stroke& l, const Stroke& r) {
      return std::tie(l.source, l.t_from) < std::tie(r.source, r.t_from);
    };
    std::sort(model.strokes.begin(), model.strokes.end(), by_place);
    if (bridge_cuts(whole, line_begin, tolerances.lift_mm, model)) {
      std::sort(model.strokes.begin(), model.strokes.end(), by_place);
    }
    std::erase_if(model.strokes, [](const Stroke& s) { return s.from == s.to; });
  }
  const Polylines joined = join_near_ends(Chains(model).polylines(), tolerances.ends_mm);

  Polylines out;
  for (std::size_t i = 0; i < joined.size(); ++i) {
    append(out, joined[i], simplified(joined[i], tolerances.simplify_mm - early, tolerances.simplify_loss - early_loss));
  }
  for (const LatticePoint dot : snapped.dots) {
    out.points.insert(out.points.end(), 2, snapped.lattice.to_mm(dot));
    out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  }
  return out;
}

}  // namespace ligne
