/// Strokes that lie on each other: one stands for all.
///
/// Most strokes coincide with none (stroke_partners.hpp) and stand at once. The others are taken in the order of their
/// precedence and compared with those that stand already. Where one of these has precedence the new stroke loses the common
/// interval, and what is left of it is tried again. Otherwise the new stroke stands, and those that it precedes after all
/// (depth decides in the middle of the common interval, which the order by whole strokes can only guess) lose theirs and are
/// tried again. So nothing that stands coincides with anything else that stands, and whatever is taken away lies within the
/// tolerance of the stroke to which it lost. Every trial takes more than the tolerance from some stroke or lets one stand
/// for good: the work ends. Since a new stroke is only held against what stands, a thousand strokes on one line do not make
/// a million pairs.
///
/// The rest of a stroke that crosses another at a very small angle may lie within the tolerance of a third, where the
/// whole did not. Strokes that turn out to coincide with such a piece come in afterwards, and what stands is not decided
/// anew: it loses to them what it must.
///
/// A cut puts the end of the loser onto the end of the winner, so that the two meet in one lattice point and the joining
/// of make_drawing.cpp sees that they continue each other.

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "base/parallel.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "linework/overlaps/stroke_index.hpp"
#include "linework/overlaps/stroke_overlap.hpp"
#include "linework/overlaps/stroke_partners.hpp"
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

/// An interval that a stroke loses.
struct Loss {
  Cut from, to;
};

/// The part of a stroke that is lost to one that stands and goes before it; a is the one that loses.
Loss loss_to(const Stroke& standing, const StrokeOverlap& common) {
  const auto end = [&](double fraction) { return fraction < 0.5 ? standing.from : standing.to; };
  return {{common.a_from, end(common.b_from)}, {common.a_to, end(common.b_to)}};
}

template <class Index>
class Precedence {
 public:
  Precedence(Index index, double tolerance_steps, double tolerance_mm)
      : index_(std::move(index)), tolerance_steps_(tolerance_steps), tolerance_mm_(tolerance_mm) {}

  /// Strokes should come in the order of their turns; one that comes later may cut more of what stands.
  void add(const Stroke& stroke, std::uint32_t turn) {
    waiting_.push_back({stroke, turn, false});
    while (!waiting_.empty()) {
      const Trial trial = waiting_.back();
      waiting_.pop_back();
      try_one(trial);
    }
  }

  /// The standing pieces of the strokes that were cut since the last call.
  std::vector<Stroke> new_pieces() {
    std::vector<Stroke> pieces;
    for (; looked_at_ < standing_.size(); ++looked_at_) {
      if (standing_[looked_at_].stands && standing_[looked_at_].is_piece) pieces.push_back(standing_[looked_at_].stroke);
    }
    return pieces;
  }

  /// A stroke, and the turn at which it came to stand.
  struct Standing {
    Stroke stroke;
    std::uint32_t turn;
    bool stands;  ///< still
    bool is_piece;
  };
  const std::vector<Standing>& standing() const { return standing_; }

 private:
  static constexpr bool kHasRuns = std::is_same_v<Index, StrokeTree>;

  /// A stroke that stands, and where the one on trial lies on it: a is the one on trial.
  struct Hit {
    std::uint32_t standing, entry;
    StrokeOverlap common;
  };

  struct Trial {
    Stroke stroke;
    std::uint32_t turn;
    bool is_piece;
  };

  void try_one(const Trial& trial);
  bool precedes(const Stroke& stroke, const Stroke& standing, const StrokeOverlap& common) const;
  bool goes_behind(const Stroke& stroke, const StrokeOrder& last, double begin, double end) const;
  bool lose_to_run(const Stroke& stroke, const SegmentRun& run, double begin, double end);
  void cut(const Stroke& stroke, std::uint32_t turn, std::vector<Loss>& losses);

  Index index_;
  double tolerance_steps_, tolerance_mm_;
  std::vector<Standing> standing_;
  std::size_t looked_at_ = 0;  ///< so many standing ones were looked at for pieces
  std::vector<Trial> waiting_;
  std::vector<std::uint32_t> indexed_;  ///< the strokes that stand or stood, in the order of the index
  std::vector<std::uint32_t> seen_;     ///< for each of them the number of the trial in which it was met last
  std::uint32_t trial_ = 0;
  std::vector<Hit> hits_;
  std::vector<Loss> losses_;
};

/// `stroke`, which comes later in the order, goes before the one that stands.
template <class Index>
bool Precedence<Index>::precedes(const Stroke& stroke, const Stroke& standing, const StrokeOverlap& common) const {
  if (rank(stroke) != rank(standing)) return rank(stroke) < rank(standing);
  const double z = depth(stroke, (common.a_from + common.a_to) / 2);
  const double z_standing = depth(standing, (common.b_from + common.b_to) / 2);
  if (std::abs(z - z_standing) > tolerance_mm_) return z < z_standing;
  return by_source(stroke, standing);
}

/// Puts what the losses leave of the stroke on the list of those to be tried.
template <class Index>
void Precedence<Index>::cut(const Stroke& stroke, std::uint32_t turn, std::vector<Loss>& losses) {
  std::sort(losses.begin(), losses.end(), [](const Loss& l, const Loss& r) {
    return std::tie(l.from.fraction, l.to.fraction) < std::tie(r.from.fraction, r.to.fraction);
  });
  const double stroke_length = length(stroke.from, stroke.to);
  Cut from{0, stroke.from};
  const auto keep = [&](const Cut& to) {
    if ((to.fraction - from.fraction) * stroke_length <= tolerance_steps_) return;
    const Stroke part = stroke_piece(stroke, from, to);
    if (part.from != part.to && part.t_from < part.t_to) waiting_.push_back({part, turn, true});
  };
  for (const Loss& loss : losses) {
    keep(loss.from);
    if (loss.to.fraction > from.fraction) from = loss.to;
  }
  keep({1, stroke.to});
}

/// Whether all strokes of which `last` is the order go before this one; they lie between two fractions of it.
template <class Index>
bool Precedence<Index>::goes_behind(const Stroke& stroke, const StrokeOrder& last, double begin, double end) const {
  constexpr double kRounding = 0x1p-8;  // in tolerances: more than that of a depth
  if (last.rank != rank(stroke)) return last.rank < rank(stroke);
  const double behind = (std::min(depth(stroke, begin), depth(stroke, end)) - last.z) / tolerance_mm_;
  return behind > 1 + kRounding || (behind > kRounding - 1 && last.source < stroke.source);
}

/// Takes the run for one loss when all of it goes before the stroke.
template <class Index>
bool Precedence<Index>::lose_to_run(const Stroke& stroke, const SegmentRun& run, double begin, double end) {
  if (!goes_behind(stroke, run.order, begin, end)) return false;
  Loss all{{1, stroke.to}, {0, stroke.from}};
  for (const std::uint32_t entry : {run.first, run.last}) {
    const Stroke& standing = standing_[indexed_[entry]].stroke;
    const auto common = overlap(stroke.from, stroke.to, standing.from, standing.to, tolerance_steps_);
    if (!common) return false;
    const Loss loss = loss_to(standing, *common);
    if (loss.from.fraction < all.from.fraction) all.from = loss.from;
    if (loss.to.fraction > all.to.fraction) all.to = loss.to;
  }
  losses_.push_back(all);
  return true;
}

template <class Index>
void Precedence<Index>::try_one(const Trial& trial) {
  const Stroke& stroke = trial.stroke;
  ++trial_;
  hits_.clear();
  losses_.clear();
  const auto visit = [&](std::uint32_t entry) {
    const std::uint32_t i = indexed_[entry];
    if (seen_[entry] == trial_) return false;
    seen_[entry] = trial_;
    const Stroke& standing = standing_[i].stroke;
    if (!stroke.needs_overlap_check && !standing.needs_overlap_check) return false;
    if (const auto common = overlap(stroke.from, stroke.to, standing.from, standing.to, tolerance_steps_)) {
      hits_.push_back({i, entry, *common});
    }
    return false;
  };
  if constexpr (kHasRuns) {
    const auto takes_run = [&](const SegmentRun& run, double begin, double end) {
      return lose_to_run(stroke, run, begin, end);
    };
    index_.query(stroke.from, stroke.to, takes_run, visit);
  } else {
    index_.query(stroke.from, stroke.to, visit);
  }
  // In the order in which they came to stand, whichever index finds them.
  std::sort(hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) { return a.entry < b.entry; });

  for (const auto& [i, entry, common] : hits_) {
    const Stroke& standing = standing_[i].stroke;
    if (!precedes(stroke, standing, common)) losses_.push_back(loss_to(standing, common));
  }
  if (!losses_.empty()) return cut(stroke, trial.turn, losses_);

  for (const auto& [i, entry, common] : hits_) {
    standing_[i].stands = false;
    index_.erase(entry);
    const auto end = [&](double fraction) { return fraction < 0.5 ? stroke.from : stroke.to; };
    Loss loss{{common.b_from, end(common.a_from)}, {common.b_to, end(common.a_to)}};
    if (loss.from.fraction > loss.to.fraction) std::swap(loss.from, loss.to);
    losses_.assign(1, loss);
    cut(standing_[i].stroke, std::max(trial.turn, standing_[i].turn), losses_);
  }
  if constexpr (kHasRuns) {
    const StrokeOrder order{rank(stroke), std::max(stroke.z_from, stroke.z_to), stroke.source};
    index_.insert(stroke.from, stroke.to, stroke.needs_overlap_check ? std::optional(order) : std::nullopt);
  } else {
    index_.insert(stroke.from, stroke.to);
  }
  indexed_.push_back(static_cast<std::uint32_t>(standing_.size()));
  seen_.push_back(0);
  standing_.push_back({stroke, trial.turn, true, trial.is_piece});
}

/// A stroke in the order in which they are tried.
struct Turn {
  std::size_t rank;
  double depth;  ///< in steps of the tolerance, so that equal depths are equal
  std::uint32_t stroke;

  Turn() = default;
  Turn(const Stroke& s, std::uint32_t number, double tolerance_mm)
      : rank(ligne::rank(s)), depth(std::floor(ligne::depth(s, 0.5) / tolerance_mm)), stroke(number) {
    if (!std::isfinite(depth)) depth = 0;
  }
};

/// The strokes that may coincide with others, in the order in which they are tried.
std::vector<Turn> find_turns(const std::vector<Stroke>& strokes, const std::vector<Partners>& partners,
                             double tolerance_mm) {
  std::vector<Turn> turns;
  for (std::uint32_t i = 0; i < partners.size(); ++i) {
    if (partners[i] != Partners::cannot) turns.emplace_back(strokes[i], i, tolerance_mm);
  }
  parallel_sort(turns.begin(), turns.end(), [&](const Turn& a, const Turn& b) {
    if (a.rank != b.rank) return a.rank < b.rank;
    if (a.depth != b.depth) return a.depth < b.depth;
    const Stroke &l = strokes[a.stroke], &r = strokes[b.stroke];
    return std::tie(l.source, l.t_from, l.t_to, a.stroke) < std::tie(r.source, r.t_from, r.t_to, b.stroke);
  });
  return turns;
}

/// The standing pieces of the strokes that may coincide with others, in the order of their turns.
template <class Index>
std::vector<Stroke> decide_with(Index index, const std::vector<Stroke>& strokes, std::vector<Partners>& partners,
                                const std::vector<Turn>& turns, double tolerance_steps, double tolerance_mm) {
  constexpr int kRounds = 3;  // the last but one finds partners of pieces of pieces
  Precedence<Index> precedence(std::move(index), tolerance_steps, tolerance_mm);
  std::vector<std::uint32_t> turn_of(strokes.size()), alone;
  for (std::uint32_t turn = 0; turn < turns.size(); ++turn) {
    const std::uint32_t i = turns[turn].stroke;
    turn_of[i] = turn;
    if (partners[i] == Partners::some) precedence.add(strokes[i], turn);
    if (partners[i] == Partners::none) alone.push_back(i);
  }
  for (int round = 1; round < kRounds && !alone.empty(); ++round) {
    const std::vector<Stroke> pieces = precedence.new_pieces();
    if (pieces.empty()) break;
    for (const std::uint32_t i : find_partners_of(pieces, strokes, alone, tolerance_steps)) {
      partners[i] = Partners::some;
      precedence.add(strokes[i], turn_of[i]);
    }
    std::erase_if(alone, [&](std::uint32_t i) { return partners[i] == Partners::some; });
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // turns and what came to stand then
  const auto& standing = precedence.standing();
  for (std::uint32_t k = 0; k < standing.size(); ++k) {
    if (standing[k].stands) order.emplace_back(standing[k].turn, k);
  }
  std::sort(order.begin(), order.end());
  std::vector<Stroke> decided;
  decided.reserve(order.size() + alone.size());
  auto next = order.begin();
  for (const std::uint32_t i : alone) {
    for (; next != order.end() && next->first < turn_of[i]; ++next) decided.push_back(standing[next->second].stroke);
    decided.push_back(strokes[i]);
  }
  for (; next != order.end(); ++next) decided.push_back(standing[next->second].stroke);
  return decided;
}

std::vector<Stroke> decide(const std::vector<Stroke>& strokes, std::vector<Partners>& partners,
                           const std::vector<Turn>& turns, double tolerance_steps, double tolerance_mm) {
  std::vector<std::uint32_t> together;
  for (std::uint32_t i = 0; i < partners.size(); ++i) {
    if (partners[i] == Partners::some) together.push_back(i);
  }
  const auto with = [&](auto index) {
    return decide_with(std::move(index), strokes, partners, turns, tolerance_steps, tolerance_mm);
  };
  if (StrokeTree::suits_runs(strokes, together, tolerance_steps) || StrokeTree::suits(strokes, together, tolerance_steps))
    return with(StrokeTree(tolerance_steps));
  return with(StrokeIndex(index_cell(strokes, together, tolerance_steps), tolerance_steps));
}

/// In a crowd, where nearly every stroke has a partner, all are compared from the beginning: there pieces find partners
/// among the few others all the time.
void take_all_of_a_crowd(std::vector<Partners>& partners) {
  constexpr std::ptrdiff_t kCrowd = 1024, kOneIn = 4;  // adjustable
  const auto some = std::count(partners.begin(), partners.end(), Partners::some);
  if (some < kCrowd || kOneIn * std::count(partners.begin(), partners.end(), Partners::none) > some) return;
  std::replace(partners.begin(), partners.end(), Partners::none, Partners::some);
}

}  // namespace

void remove_coincident_strokes(StrokeModel& model, double tolerance_mm) {
  std::vector<Stroke>& strokes = model.strokes;
  // The lattice knows nothing finer than its step.
  const double tolerance_steps = std::max(tolerance_mm / model.lattice.step_mm, 1.0);
  std::vector<Partners> partners = find_partners(strokes, tolerance_steps);
  take_all_of_a_crowd(partners);
  const std::vector<Turn> turns = find_turns(strokes, partners, tolerance_mm);
  if (turns.empty()) return;
  const std::vector<Stroke> decided = decide(strokes, partners, turns, tolerance_steps, tolerance_mm);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (partners[i] == Partners::cannot) strokes[kept++] = strokes[i];
  }
  strokes.resize(kept);
  strokes.insert(strokes.end(), decided.begin(), decided.end());
}

}  // namespace ligne
