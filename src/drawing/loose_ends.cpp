#include "drawing/loose_ends.hpp"

#include <cmath>
#include <vector>

#include "drawing/key_table.hpp"
#include "drawing/stroke_chains.hpp"
#include "drawing/stroke_index.hpp"

namespace ligne {
namespace {

constexpr double kLeastCosine = 0.5;  ///< adjustable: of the turn from a line into what joins it to the next
/// Chains whose ends may be joined to each other are so many gaps long, or a speck would be a ring.
constexpr double kRingInGaps = 4;

struct LooseEnd {
  std::uint32_t stroke;
  bool at_from;
  std::uint32_t next = KeyTable::kNone;     ///< in its cell
  std::uint32_t nearest = KeyTable::kNone;  ///< of the others that it may be joined to
};

class LooseEnds {
 public:
  LooseEnds(const std::vector<Stroke>& strokes, double gap)
      : strokes_(strokes), chains_(strokes), gap_(gap), grid_(2 * gap, gap) {
    for (const std::uint32_t i : chains_.seen()) {
      const Stroke& s = strokes[i];
      if (!is_edge(s) || s.line_class == LineClass::mesh || s.from == s.to) continue;
      for (const bool at_from : {true, false}) {
        if (!chains_.is_free(at_from ? s.from : s.to)) continue;
        std::uint32_t& first = cells_[grid_.cell_of(at_from ? s.from : s.to)];
        ends_.push_back({i, at_from, first});
        first = static_cast<std::uint32_t>(ends_.size() - 1);
      }
    }
    for (std::uint32_t e = 0; e < ends_.size(); ++e) ends_[e].nearest = nearest(e);
  }

  /// Calls join(end, end) for each two that are each other's nearest.
  template <class Join>
  void pairs(const Join& join) const {
    for (std::uint32_t e = 0; e < ends_.size(); ++e) {
      const std::uint32_t other = ends_[e].nearest;
      if (other != KeyTable::kNone && other > e && ends_[other].nearest == e) join(ends_[e], ends_[other]);
    }
  }

  double line_length(const LooseEnd& end) const { return chains_.chain(chains_.chain_of(end.stroke)).length; }

 private:
  LatticePoint point(const LooseEnd& e) const { return e.at_from ? strokes_[e.stroke].from : strokes_[e.stroke].to; }

  /// The line goes on towards the point; a stroke shorter than the way to it has no direction that says anything.
  bool leads_to(const LooseEnd& e, LatticePoint p, double distance) const {
    const Stroke& s = strokes_[e.stroke];
    const double length = page_length(s);
    if (length <= distance) return true;
    const LatticePoint end = point(e), start = e.at_from ? s.to : s.from;
    const double along =
        (double(end.x) - start.x) * (double(p.x) - end.x) + (double(end.y) - start.y) * (double(p.y) - end.y);
    return along >= kLeastCosine * length * distance;
  }

  std::uint32_t nearest(std::uint32_t e) const {
    const LooseEnd& end = ends_[e];
    const LatticePoint p = point(end);
    std::uint32_t best = KeyTable::kNone;
    double best_distance = gap_;
    grid_.walk(p, p, [&](std::uint64_t cell) {
      for (std::uint32_t o = cells_.find(cell); o != KeyTable::kNone; o = ends_[o].next) {
        if (o == e) continue;
        const LooseEnd& other = ends_[o];
        const LatticePoint q = point(other);
        const double distance = std::hypot(double(q.x) - p.x, double(q.y) - p.y);
        if (distance >= gap_ || distance > best_distance || (distance == best_distance && o > best)) continue;
        const bool same = chains_.chain_of(end.stroke) == chains_.chain_of(other.stroke);
        if (same && line_length(end) < kRingInGaps * gap_) continue;
        if (!leads_to(end, q, distance) || !leads_to(other, p, distance)) continue;
        best = o;
        best_distance = distance;
      }
      return false;
    });
    return best;
  }

  const std::vector<Stroke>& strokes_;
  StrokeChains chains_;
  double gap_;
  SegmentGrid grid_;
  KeyTable cells_;
  std::vector<LooseEnd> ends_;
};

}  // namespace

std::size_t join_loose_ends(StrokeModel& model, double gap_mm, const MakeSource& make_source) {
  const LooseEnds ends(model.strokes, gap_mm / model.lattice.step_mm);
  std::vector<Stroke> added;
  ends.pairs([&](const LooseEnd& a, const LooseEnd& b) {
    const Stroke &s = model.strokes[a.stroke], &t = model.strokes[b.stroke];
    Stroke joint = ends.line_length(a) < ends.line_length(b) ? t : s;
    joint.t_from = 0;
    joint.t_to = 1;
    joint.from = a.at_from ? s.from : s.to;
    joint.to = b.at_from ? t.from : t.to;
    joint.z_from = a.at_from ? s.z_from : s.z_to;
    joint.z_to = b.at_from ? t.z_from : t.z_to;
    joint.w_from = a.at_from ? s.w_from : s.w_to;
    joint.w_to = b.at_from ? t.w_from : t.w_to;
    model.intersections.push_back(make_source(joint));
    joint.source = model.edge_count + static_cast<std::uint32_t>(model.intersections.size()) - 1;
    added.push_back(joint);
  });
  model.strokes.insert(model.strokes.end(), added.begin(), added.end());
  return added.size();
}

}  // namespace ligne
