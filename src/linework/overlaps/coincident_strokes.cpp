/// Overlapping strokes are decided one after the other, in the order of precedence. A stroke is compared with the pieces
/// that stay of its partners before it:
/// - It loses the common intervals with pieces that precede it.
/// - Pieces that it precedes nevertheless lose their common intervals with its rests. This happens because precedence
///   depends on the depth in the middle of the common interval, while the order is by the depth in the middle of whole
///   strokes.

#include "linework/overlaps/coincident_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/indices_where.hpp"
#include "base/parallel.hpp"
#include "geometry/search/line_cells.hpp"
#include "linework/overlaps/compared_strokes.hpp"
#include "linework/overlaps/overlap_search.hpp"

namespace ligne {
namespace {

/// Sorts the strokes numbered in `of` by falling precedence, with the depths in their middles.
void sort_by_precedence(const std::vector<Stroke>& strokes, std::vector<std::uint32_t>& of, double tolerance_mm) {
  using Entry = std::pair<PrecedenceKey, std::uint32_t>;
  std::vector<Entry> order(of.size());
  for (std::size_t k = 0; k < of.size(); ++k) order[k] = {precedence_key(strokes[of[k]], 0.5, tolerance_mm), of[k]};
  parallel_sort(order.begin(), order.end(), [&](const Entry& a, const Entry& b) {
    if (a.first != b.first) return a.first < b.first;
    const Stroke &l = strokes[a.second], &r = strokes[b.second];
    return std::tie(l.source, l.t_from, l.t_to, a.second) < std::tie(r.source, r.t_from, r.t_to, b.second);
  });
  for (std::size_t k = 0; k < of.size(); ++k) of[k] = order[k].second;
}

/// Returns, ascending, the numbers of the strokes longer than the tolerance that need a check
/// (Stroke::needs_overlap_check) or may pass near one that does. Where most strokes need one, all pass near one.
std::vector<std::uint32_t> strokes_to_compare(const std::vector<Stroke>& strokes, double tolerance_steps) {
  // Adjustable: least side of a cell, a 2048th of the lattice; number of cells along the lattice for each stroke along it;
  // smallest ratio of all strokes to those that need a check. The test of a stroke takes about a third of a comparison.
  constexpr double kLeastCell = 1 << 15, kCellsEach = 8;
  constexpr std::size_t kTimes = 2;
  const auto is_long = [&](std::size_t i) { return page_length(strokes[i]) > tolerance_steps; };
  const auto flagged =
      indices_where(strokes.size(), [&](std::size_t i) { return strokes[i].needs_overlap_check && is_long(i); });
  if (flagged.empty() || kTimes * flagged.size() > strokes.size())
    return flagged.empty() ? flagged : indices_where(strokes.size(), is_long);
  const double along = kCellsEach * std::sqrt(static_cast<double>(flagged.size()) + 1);
  LineCells cells(walked_cell(strokes, std::max(kLeastCell, 2 * kLatticeLimit / along)));
  for (const std::uint32_t i : flagged) cells.insert(i, strokes[i].from, strokes[i].to);
  const auto is_any = [](std::uint32_t) { return true; };
  return indices_where(strokes.size(), [&](std::size_t i) {
    return is_long(i) && cells.near(strokes[i].from, strokes[i].to, tolerance_steps, is_any);
  });
}

/// The part of a stroke that another one covers. The fractions are of both strokes at the ends of their common interval.
CoveredPart covered_by(const Stroke& other, double from, double other_from, double to, double other_to) {
  const auto end = [&](double fraction) { return fraction < 0.5 ? other.from : other.to; };
  CoveredPart part{{from, end(other_from)}, {to, end(other_to)}};
  if (from > to) std::swap(part.from, part.to);
  return part;
}

/// Resolves pairs of overlapping strokes, ascending, where strokes are numbered by falling precedence.
class PairResolver {
 public:
  PairResolver(const std::vector<Stroke>& strokes, const OverlapTolerance& tolerance)
      : strokes_(strokes), tolerance_(tolerance), left_(strokes.size()) {}

  /// Returns what stays of the strokes in pairs, ascending. It may overlap other strokes only where a cut has made new ends.
  std::vector<CutStroke> resolve(std::span<const StrokePair> pairs) {
    std::vector<std::uint8_t> is_in_pair(strokes_.size(), 0);
    for (const StrokePair& pair : pairs) is_in_pair[pair.later] = is_in_pair[pair.earlier] = 1;
    const std::vector<std::uint32_t> in_pairs = indices_of_marks(is_in_pair);
    auto first = pairs.begin();
    for (const std::uint32_t i : in_pairs) {
      const auto last = std::find_if(first, pairs.end(), [&](const StrokePair& pair) { return pair.later != i; });
      decide(i, {first, last});
      first = last;
    }
    std::vector<CutStroke> cut;
    cut.reserve(in_pairs.size());
    for (const std::uint32_t i : in_pairs) cut.push_back({i, std::move(left_[i])});
    return cut;
  }

 private:
  /// A piece that stays of an earlier stroke.
  struct Hit {
    std::uint32_t stroke, piece;
  };

  /// Decides a stroke. `pairs` are those in which it is the later one; the others in them have been decided.
  void decide(std::uint32_t number, std::span<const StrokePair> pairs) {
    const Stroke& stroke = strokes_[number];
    std::vector<CoveredPart> covered;
    std::vector<Hit> beaten;
    for (const StrokePair& pair : pairs) {
      const std::vector<Stroke>& pieces = left_[pair.earlier];
      const auto [first, last] = pieces_beside(stroke, pair.earlier);
      for (std::uint32_t k = first; k < last; ++k) {
        const auto common = overlap(stroke.from, stroke.to, pieces[k].from, pieces[k].to, tolerance_.steps);
        if (!common) continue;
        if (precedes(stroke, pieces[k], *common, tolerance_.mm)) {
          beaten.push_back({pair.earlier, k});
        } else {
          covered.push_back(covered_by(pieces[k], common->a_from, common->b_from, common->a_to, common->b_to));
        }
      }
    }
    left_[number] = rests_of(stroke, covered, tolerance_.steps);
    cut_beaten(beaten, left_[number]);
  }

  /// The range of the pieces of another stroke beside a stroke. Pieces follow each other along their stroke.
  std::pair<std::uint32_t, std::uint32_t> pieces_beside(const Stroke& stroke, std::uint32_t other) const {
    const std::vector<Stroke>& pieces = left_[other];
    const Stroke& whole = strokes_[other];
    const auto along = [&](LatticePoint p) { return glm::dot(offset(whole.from, whole.to), offset(whole.from, p)); };
    const double slack = 2 * tolerance_.steps * page_length(whole);
    const auto range = std::minmax({along(stroke.from), along(stroke.to)});
    const auto is_before = [&](const Stroke& piece) { return along(piece.to) < range.first - slack; };
    const auto begins_before_end = [&](const Stroke& piece) { return along(piece.from) <= range.second + slack; };
    const auto first = std::partition_point(pieces.begin(), pieces.end(), is_before);
    const auto last = std::partition_point(first, pieces.end(), begins_before_end);
    return {static_cast<std::uint32_t>(first - pieces.begin()), static_cast<std::uint32_t>(last - pieces.begin())};
  }

  /// Cuts the pieces that a stroke precedes, by what stays of it.
  void cut_beaten(const std::vector<Hit>& beaten, const std::vector<Stroke>& rests) {
    // From the last piece of a stroke to the first, so that the others keep their places.
    for (auto hit = beaten.rbegin(); hit != beaten.rend(); ++hit) {
      std::vector<Stroke>& pieces = left_[hit->stroke];
      const Stroke piece = pieces[hit->piece];
      std::vector<CoveredPart> covered;
      for (const Stroke& rest : rests) {
        const auto common = overlap(rest.from, rest.to, piece.from, piece.to, tolerance_.steps);
        if (common) covered.push_back(covered_by(rest, common->b_from, common->a_from, common->b_to, common->a_to));
      }
      if (covered.empty()) continue;
      const std::vector<Stroke> left = rests_of(piece, covered, tolerance_.steps);
      const auto place = pieces.erase(pieces.begin() + hit->piece);
      pieces.insert(place, left.begin(), left.end());
    }
  }

  const std::vector<Stroke>& strokes_;
  OverlapTolerance tolerance_;
  std::vector<std::vector<Stroke>> left_;  ///< what stays of each stroke that was decided
};

/// Whether strokes overlap so many others that comparing all of them at once would take most of the time. A sample tells.
bool is_crowd(const std::vector<Stroke>& strokes, double tolerance_steps) {
  constexpr std::size_t kSample = 1024;  // strokes of the sample
  constexpr double kMany = 64;           // overlaps of a stroke with others, on the average; adjustable
  if (strokes.size() < 4 * kSample) return false;
  ComparedStrokes sample;
  for (std::size_t k = 0; k < kSample; ++k) sample.add({&strokes[k * strokes.size() / kSample], 1});
  const auto pairs = static_cast<double>(OverlapSearch(tolerance_steps).find_new(sample).size());
  const double times = static_cast<double>(strokes.size()) / kSample;
  return 2 * pairs * times > kMany * kSample;
}

/// Cuts strokes until no two overlap, or fewer than `least` are new. Rests may overlap strokes that their wholes did not,
/// where a wedge has become short enough.
void resolve_overlaps(ComparedStrokes& compared, OverlapSearch& search, std::size_t least,
                      const OverlapTolerance& tolerance) {
  while (compared.next_id - compared.first_new >= least) {
    const std::vector<StrokePair> pairs = search.find_new(compared);
    compared.replace(PairResolver(compared.strokes, tolerance).resolve(pairs));
  }
}

/// Returns what stays of strokes, which are sorted by precedence. A crowd is taken in batches of half as many strokes as
/// stay of those before: they cover most of a batch, so that each stroke is compared with few others. A few new rests wait
/// for the next batch.
std::vector<Stroke> without_overlaps(const std::vector<Stroke>& strokes, const OverlapTolerance& tolerance) {
  // Adjustable: strokes in a batch; ratio of all strokes to new ones above which these wait for the next batch.
  constexpr std::size_t kLeast = 8192, kFewNew = 8;
  const std::size_t least = is_crowd(strokes, tolerance.steps) ? kLeast : strokes.size();
  ComparedStrokes kept;
  OverlapSearch search(tolerance.steps);
  for (std::size_t begin = 0, end = 0; begin < strokes.size(); begin = end) {
    end = std::min(strokes.size(), begin + std::max(least, kept.strokes.size() / 2));
    kept.add(std::span(strokes).subspan(begin, end - begin));
    resolve_overlaps(kept, search, end < strokes.size() ? kept.strokes.size() / kFewNew : 1, tolerance);
  }
  return std::move(kept.strokes);
}

}  // namespace

std::vector<Stroke> rests_of(const Stroke& stroke, std::vector<CoveredPart>& covered, double tolerance_steps) {
  std::ranges::sort(covered, {}, [](const CoveredPart& part) { return std::tuple(part.from.fraction, part.to.fraction); });
  const double stroke_length = page_length(stroke);
  std::vector<Stroke> rests;
  StrokeCut from{0, stroke.from};
  const auto add_rest_to = [&](const StrokeCut& to) {
    if ((to.fraction - from.fraction) * stroke_length <= tolerance_steps) return;
    const Stroke rest = stroke_piece(stroke, from, to);
    if (rest.from != rest.to && rest.t_from < rest.t_to) rests.push_back(rest);
  };
  for (const CoveredPart& part : covered) {
    add_rest_to(part.from);
    if (part.to.fraction > from.fraction) from = part.to;
  }
  add_rest_to({1, stroke.to});
  return rests;
}

void ComparedStrokes::add(std::span<const Stroke> added) {
  strokes.insert(strokes.end(), added.begin(), added.end());
  for (std::size_t k = 0; k < added.size(); ++k) ids.push_back(next_id++);
}

void ComparedStrokes::replace(std::span<const CutStroke> cut) {
  ComparedStrokes changed{{}, {}, next_id, next_id};
  changed.strokes.reserve(strokes.size() + cut.size());
  changed.ids.reserve(strokes.size() + cut.size());
  auto next = cut.begin();
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    const Stroke& whole = strokes[i];
    const bool is_cut = next != cut.end() && next->number == i;
    const std::vector<Stroke>* rests = is_cut ? &(next++)->rests : nullptr;
    if (!rests || (rests->size() == 1 && (*rests)[0].from == whole.from && (*rests)[0].to == whole.to)) {
      changed.strokes.push_back(whole);
      changed.ids.push_back(ids[i]);
    } else {
      changed.add(*rests);
    }
  }
  *this = std::move(changed);
}

void remove_coincident_strokes(StrokeModel& model, double tolerance_mm) {
  std::vector<Stroke>& strokes = model.strokes;
  // Positions on the lattice are known to one step.
  const OverlapTolerance tolerance{std::max(tolerance_mm / model.lattice.step_mm, 1.0), tolerance_mm};
  std::vector<std::uint32_t> order = strokes_to_compare(strokes, tolerance.steps);
  if (order.empty()) return;
  std::vector<Stroke> others;
  others.reserve(strokes.size());
  for (std::size_t i = 0, k = 0; i < strokes.size(); ++i) {
    const bool is_chosen = k < order.size() && order[k] == i;
    k += is_chosen;
    if (!is_chosen) others.push_back(strokes[i]);
  }
  sort_by_precedence(strokes, order, tolerance_mm);
  ComparedStrokes compared;
  for (const std::uint32_t i : order) compared.add({&strokes[i], 1});
  compared.replace(thin_crowded_lines(compared.strokes, tolerance));
  const std::vector<Stroke> left = without_overlaps(compared.strokes, tolerance);
  others.insert(others.end(), left.begin(), left.end());
  strokes = std::move(others);
}

}  // namespace ligne
