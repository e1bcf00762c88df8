/// Resolution of overlaps: where strokes lie on each other, only one of them stays.
///
/// Most strokes overlap no other one (overlapping_strokes.hpp) and are kept at once. The others are decided in the order of
/// their precedence. Each is compared with the strokes kept so far:
/// - If it overlaps a kept stroke of higher precedence, it loses the common interval, and the rest is decided again.
/// - Otherwise it is kept. Kept strokes of lower precedence lose the common interval, and their rests are decided
///   again. This happens because precedence depends on the depth in the middle of the common interval, while strokes
///   are decided in the order of the depth in the middle of whole strokes.
///
/// So kept strokes never overlap each other, and everything that is removed lies within the tolerance of the stroke that
/// covers it. Each decision cuts away more than the tolerance or keeps a stroke for good, therefore the process ends. A
/// stroke is compared with kept strokes only, so a thousand strokes on one line do not make a million pairs.
///
/// A stroke may overlap another one only after a cut: the rest of a stroke that crosses a second one at a very small angle
/// can lie within the tolerance of a third. Strokes that overlap such rests are decided afterwards.
///
/// A cut moves the new end onto the end of the covering stroke, so that both meet at one lattice point and make_drawing.cpp
/// joins them.

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "base/parallel.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "linework/overlaps/overlapping_strokes.hpp"
#include "linework/overlaps/stroke_index.hpp"
#include "linework/overlaps/stroke_overlap.hpp"
#include "linework/overlaps/stroke_tree.hpp"
#include "linework/stroke_piece.hpp"

namespace ligne {
namespace {

std::size_t rank(const Stroke& s) {
  const std::size_t group = !s.visible ? 2 : s.level > 0 ? 1 : 0;
  return group * kLineClassCount + static_cast<std::size_t>(s.line_class);
}

bool by_source(const Stroke& l, const Stroke& r) {
  return std::tie(l.source, l.t_from, l.t_to) < std::tie(r.source, r.t_from, r.t_to);
}

double depth(const Stroke& s, double fraction) { return (1 - fraction) * s.z_from + fraction * s.z_to; }

using Cut = StrokeCut;

/// An interval of a stroke that another stroke covers.
struct CoveredInterval {
  Cut from, to;
};

/// The interval of stroke a that the kept stroke b covers.
CoveredInterval covered_by(const Stroke& kept, const StrokeOverlap& common) {
  const auto end = [&](double fraction) { return fraction < 0.5 ? kept.from : kept.to; };
  return {{common.a_from, end(common.b_from)}, {common.a_to, end(common.b_to)}};
}

template <class Index>
class OverlapResolver {
 public:
  OverlapResolver(Index index, double tolerance_steps, double tolerance_mm)
      : index_(std::move(index)), tolerance_steps_(tolerance_steps), tolerance_mm_(tolerance_mm) {}

  /// Decides a stroke and all rests that follow from it. `position` is its place in the order of precedence; strokes that
  /// come out of order cut more of the kept ones.
  void add(const Stroke& stroke, std::uint32_t position) {
    undecided_.push_back({stroke, position, false});
    while (!undecided_.empty()) {
      const Candidate candidate = undecided_.back();
      undecided_.pop_back();
      decide_one(candidate);
    }
  }

  /// The kept rests of strokes that were cut since the last call.
  std::vector<Stroke> new_rests() {
    std::vector<Stroke> rests;
    for (; reported_ < kept_.size(); ++reported_) {
      if (kept_[reported_].is_kept && kept_[reported_].is_rest) rests.push_back(kept_[reported_].stroke);
    }
    return rests;
  }

  /// A stroke that was kept when it was decided.
  struct Kept {
    Stroke stroke;
    /// Position in the order of precedence. For a rest it is the last position among the strokes whose decisions made
    /// it.
    std::uint32_t position;
    bool is_kept;  ///< false after a later stroke has cut it
    bool is_rest;
  };
  const std::vector<Kept>& kept() const { return kept_; }

 private:
  static constexpr bool kHasRuns = std::is_same_v<Index, StrokeTree>;

  /// A kept stroke b that overlaps the candidate a.
  struct Hit {
    std::uint32_t kept;
    StrokeOverlap common;
  };

  struct Candidate {
    Stroke stroke;
    std::uint32_t position;
    bool is_rest;
  };

  void decide_one(const Candidate& candidate);
  void find_hits(const Stroke& stroke);
  bool precedes(const Stroke& stroke, const Stroke& kept, const StrokeOverlap& common) const;
  bool goes_behind(const Stroke& stroke, const StrokeOrder& last, double begin, double end) const;
  bool cover_by_run(const Stroke& stroke, const SegmentRun& run, double begin, double end);
  void cut(const Stroke& stroke, std::uint32_t position, std::vector<CoveredInterval>& covered);
  void keep(const Candidate& candidate);

  Index index_;  ///< numbers strokes as kept_ does
  double tolerance_steps_, tolerance_mm_;
  std::vector<Kept> kept_;
  std::size_t reported_ = 0;  ///< number of kept strokes that new_rests() has passed
  std::vector<Candidate> undecided_;
  std::vector<std::uint32_t> last_met_;  ///< by kept stroke: number of the decision that found it last
  std::uint32_t decision_ = 0;
  std::vector<Hit> hits_;
  std::vector<CoveredInterval> covered_;
};

/// Whether `stroke`, which is decided later, has the higher precedence.
template <class Index>
bool OverlapResolver<Index>::precedes(const Stroke& stroke, const Stroke& kept, const StrokeOverlap& common) const {
  if (rank(stroke) != rank(kept)) return rank(stroke) < rank(kept);
  const double z = depth(stroke, (common.a_from + common.a_to) / 2);
  const double z_kept = depth(kept, (common.b_from + common.b_to) / 2);
  if (std::abs(z - z_kept) > tolerance_mm_) return z < z_kept;
  return by_source(stroke, kept);
}

/// Puts the rests that the covered intervals leave of the stroke on the list of undecided ones.
template <class Index>
void OverlapResolver<Index>::cut(const Stroke& stroke, std::uint32_t position, std::vector<CoveredInterval>& covered) {
  std::sort(covered.begin(), covered.end(), [](const CoveredInterval& l, const CoveredInterval& r) {
    return std::tie(l.from.fraction, l.to.fraction) < std::tie(r.from.fraction, r.to.fraction);
  });
  const double stroke_length = length(stroke.from, stroke.to);
  Cut from{0, stroke.from};
  const auto add_rest_to = [&](const Cut& to) {
    if ((to.fraction - from.fraction) * stroke_length <= tolerance_steps_) return;
    const Stroke rest = stroke_piece(stroke, from, to);
    if (rest.from != rest.to && rest.t_from < rest.t_to) undecided_.push_back({rest, position, true});
  };
  for (const CoveredInterval& interval : covered) {
    add_rest_to(interval.from);
    if (interval.to.fraction > from.fraction) from = interval.to;
  }
  add_rest_to({1, stroke.to});
}

/// Whether all strokes of a run precede this stroke. `last` is the upper bound of their order, `begin` and `end` are
/// the fractions of this stroke at the ends of the run.
template <class Index>
bool OverlapResolver<Index>::goes_behind(const Stroke& stroke, const StrokeOrder& last, double begin, double end) const {
  constexpr double kRounding = 0x1p-8;  // largest rounding error of a depth, in tolerances
  if (last.rank != rank(stroke)) return last.rank < rank(stroke);
  const double behind = (std::min(depth(stroke, begin), depth(stroke, end)) - last.z) / tolerance_mm_;
  return behind > 1 + kRounding || (behind > kRounding - 1 && last.source < stroke.source);
}

/// Adds the run as one covered interval if all of its strokes precede this one. Returns whether it did.
template <class Index>
bool OverlapResolver<Index>::cover_by_run(const Stroke& stroke, const SegmentRun& run, double begin, double end) {
  if (!goes_behind(stroke, run.order, begin, end)) return false;
  CoveredInterval whole{{1, stroke.to}, {0, stroke.from}};
  for (const std::uint32_t i : {run.first, run.last}) {
    const Stroke& kept = kept_[i].stroke;
    const auto common = overlap(stroke.from, stroke.to, kept.from, kept.to, tolerance_steps_);
    if (!common) return false;
    const CoveredInterval interval = covered_by(kept, *common);
    if (interval.from.fraction < whole.from.fraction) whole.from = interval.from;
    if (interval.to.fraction > whole.to.fraction) whole.to = interval.to;
  }
  covered_.push_back(whole);
  return true;
}

/// Finds the kept strokes that overlap this one, in the order in which they were kept, and the runs that cover it.
template <class Index>
void OverlapResolver<Index>::find_hits(const Stroke& stroke) {
  ++decision_;
  hits_.clear();
  covered_.clear();
  const auto visit = [&](std::uint32_t i) {
    if (last_met_[i] == decision_) return false;
    last_met_[i] = decision_;
    const Stroke& kept = kept_[i].stroke;
    if (!stroke.needs_overlap_check && !kept.needs_overlap_check) return false;
    if (const auto common = overlap(stroke.from, stroke.to, kept.from, kept.to, tolerance_steps_)) {
      hits_.push_back({i, *common});
    }
    return false;
  };
  if constexpr (kHasRuns) {
    const auto takes_run = [&](const SegmentRun& run, double begin, double end) {
      return cover_by_run(stroke, run, begin, end);
    };
    index_.query(stroke.from, stroke.to, takes_run, visit);
  } else {
    index_.query(stroke.from, stroke.to, visit);
  }
  std::sort(hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) { return a.kept < b.kept; });
}

template <class Index>
void OverlapResolver<Index>::keep(const Candidate& candidate) {
  const Stroke& stroke = candidate.stroke;
  if constexpr (kHasRuns) {
    const StrokeOrder order{rank(stroke), std::max(stroke.z_from, stroke.z_to), stroke.source};
    index_.insert(stroke.from, stroke.to, stroke.needs_overlap_check ? std::optional(order) : std::nullopt);
  } else {
    index_.insert(stroke.from, stroke.to);
  }
  last_met_.push_back(0);
  kept_.push_back({stroke, candidate.position, true, candidate.is_rest});
}

template <class Index>
void OverlapResolver<Index>::decide_one(const Candidate& candidate) {
  const Stroke& stroke = candidate.stroke;
  find_hits(stroke);
  for (const auto& [i, common] : hits_) {
    const Stroke& kept = kept_[i].stroke;
    if (!precedes(stroke, kept, common)) covered_.push_back(covered_by(kept, common));
  }
  if (!covered_.empty()) return cut(stroke, candidate.position, covered_);

  for (const auto& [i, common] : hits_) {
    kept_[i].is_kept = false;
    index_.erase(i);
    const auto end = [&](double fraction) { return fraction < 0.5 ? stroke.from : stroke.to; };
    CoveredInterval interval{{common.b_from, end(common.a_from)}, {common.b_to, end(common.a_to)}};
    if (interval.from.fraction > interval.to.fraction) std::swap(interval.from, interval.to);
    covered_.assign(1, interval);
    cut(kept_[i].stroke, std::max(candidate.position, kept_[i].position), covered_);
  }
  keep(candidate);
}

/// The precedence of a whole stroke, by which strokes are decided one after the other.
struct StrokePrecedence {
  std::size_t rank;
  double depth;  ///< in tolerances, rounded down, so that equal depths compare equal
  std::uint32_t stroke;

  StrokePrecedence() = default;
  StrokePrecedence(const Stroke& s, std::uint32_t number, double tolerance_mm)
      : rank(ligne::rank(s)), depth(std::floor(ligne::depth(s, 0.5) / tolerance_mm)), stroke(number) {
    if (!std::isfinite(depth)) depth = 0;
  }
};

/// The strokes that may overlap others, by falling precedence.
std::vector<StrokePrecedence> precedence_order(const std::vector<Stroke>& strokes, const std::vector<OverlapState>& states,
                                               double tolerance_mm) {
  std::vector<StrokePrecedence> order;
  for (std::uint32_t i = 0; i < states.size(); ++i) {
    if (states[i] != OverlapState::excluded) order.emplace_back(strokes[i], i, tolerance_mm);
  }
  parallel_sort(order.begin(), order.end(), [&](const StrokePrecedence& a, const StrokePrecedence& b) {
    if (a.rank != b.rank) return a.rank < b.rank;
    if (a.depth != b.depth) return a.depth < b.depth;
    const Stroke &l = strokes[a.stroke], &r = strokes[b.stroke];
    return std::tie(l.source, l.t_from, l.t_to, a.stroke) < std::tie(r.source, r.t_from, r.t_to, b.stroke);
  });
  return order;
}

/// Returns the kept strokes and the rests of all strokes of the order, by falling precedence.
template <class Index>
std::vector<Stroke> resolve_with(Index index, const std::vector<Stroke>& strokes, std::vector<OverlapState>& states,
                                 const std::vector<StrokePrecedence>& order, double tolerance_steps, double tolerance_mm) {
  // Rounds of searching for overlaps with rests; the second round is for rests of rests.
  constexpr int kSearches = 2;
  OverlapResolver<Index> resolver(std::move(index), tolerance_steps, tolerance_mm);
  std::vector<std::uint32_t> position_of(strokes.size()), alone;
  for (std::uint32_t position = 0; position < order.size(); ++position) {
    const std::uint32_t i = order[position].stroke;
    position_of[i] = position;
    if (states[i] == OverlapState::overlapping) resolver.add(strokes[i], position);
    if (states[i] == OverlapState::alone) alone.push_back(i);
  }
  for (int search = 0; search < kSearches && !alone.empty(); ++search) {
    const std::vector<Stroke> rests = resolver.new_rests();
    if (rests.empty()) break;
    for (const std::uint32_t i : strokes_that_overlap(rests, strokes, alone, tolerance_steps)) {
      states[i] = OverlapState::overlapping;
      resolver.add(strokes[i], position_of[i]);
    }
    std::erase_if(alone, [&](std::uint32_t i) { return states[i] == OverlapState::overlapping; });
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> kept_order;  // position, kept stroke
  const auto& kept = resolver.kept();
  for (std::uint32_t k = 0; k < kept.size(); ++k) {
    if (kept[k].is_kept) kept_order.emplace_back(kept[k].position, k);
  }
  std::sort(kept_order.begin(), kept_order.end());
  std::vector<Stroke> resolved;
  resolved.reserve(kept_order.size() + alone.size());
  auto next = kept_order.begin();
  for (const std::uint32_t i : alone) {
    for (; next != kept_order.end() && next->first < position_of[i]; ++next) resolved.push_back(kept[next->second].stroke);
    resolved.push_back(strokes[i]);
  }
  for (; next != kept_order.end(); ++next) resolved.push_back(kept[next->second].stroke);
  return resolved;
}

/// Chooses the index: a tree where many strokes lie on each other or side by side, a grid otherwise.
std::vector<Stroke> resolve(const std::vector<Stroke>& strokes, std::vector<OverlapState>& states,
                            const std::vector<StrokePrecedence>& order, double tolerance_steps, double tolerance_mm) {
  std::vector<std::uint32_t> overlapping;
  for (std::uint32_t i = 0; i < states.size(); ++i) {
    if (states[i] == OverlapState::overlapping) overlapping.push_back(i);
  }
  const auto with = [&](auto index) {
    return resolve_with(std::move(index), strokes, states, order, tolerance_steps, tolerance_mm);
  };
  if (StrokeTree::suits_runs(strokes, overlapping, tolerance_steps) ||
      StrokeTree::suits(strokes, overlapping, tolerance_steps))
    return with(StrokeTree(tolerance_steps));
  return with(StrokeIndex(index_cell(strokes, overlapping, tolerance_steps), tolerance_steps));
}

/// Compares all strokes from the beginning where nearly all of many strokes overlap. Rests would overlap the few other
/// strokes all the time; comparing these too spares the searches for rests.
void compare_all_where_most_overlap(std::vector<OverlapState>& states) {
  // Adjustable: fewest overlapping strokes, and their smallest ratio to the other strokes.
  constexpr std::ptrdiff_t kMinOverlapping = 1024, kTimes = 4;
  const auto overlapping = std::count(states.begin(), states.end(), OverlapState::overlapping);
  if (overlapping < kMinOverlapping || kTimes * std::count(states.begin(), states.end(), OverlapState::alone) > overlapping)
    return;
  std::replace(states.begin(), states.end(), OverlapState::alone, OverlapState::overlapping);
}

}  // namespace

void remove_coincident_strokes(StrokeModel& model, double tolerance_mm) {
  std::vector<Stroke>& strokes = model.strokes;
  // Positions on the lattice are known to one step.
  const double tolerance_steps = std::max(tolerance_mm / model.lattice.step_mm, 1.0);
  std::vector<OverlapState> states = find_overlapping_strokes(strokes, tolerance_steps);
  compare_all_where_most_overlap(states);
  const std::vector<StrokePrecedence> order = precedence_order(strokes, states, tolerance_mm);
  if (order.empty()) return;
  const std::vector<Stroke> resolved = resolve(strokes, states, order, tolerance_steps, tolerance_mm);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (states[i] == OverlapState::excluded) strokes[kept++] = strokes[i];
  }
  strokes.resize(kept);
  strokes.insert(strokes.end(), resolved.begin(), resolved.end());
}

}  // namespace ligne
