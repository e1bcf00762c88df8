/// Strokes are decided one after the other, in the order of precedence. A stroke is compared with the pieces that stay of
/// its partners before it:
/// - It loses the common intervals with pieces that precede it.
/// - Pieces that it precedes nevertheless lose their common intervals with its rests. This happens because precedence
///   depends on the depth in the middle of the common interval, while the order is by the depth in the middle of whole
///   strokes.

#include "linework/overlaps/resolve_pairs.hpp"

#include <algorithm>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "linework/overlaps/precedence.hpp"

namespace ligne {
namespace {

/// The part of a stroke that another one covers. The fractions are of both strokes at the ends of their common interval.
CoveredPart covered_by(const Stroke& other, double from, double other_from, double to, double other_to) {
  const auto end = [&](double fraction) { return fraction < 0.5 ? other.from : other.to; };
  CoveredPart part{{from, end(other_from)}, {to, end(other_to)}};
  if (from > to) std::swap(part.from, part.to);
  return part;
}

/// Resolves the pairs of one call. Members are the strokes in pairs, in the order in which they are decided; a member's
/// number is its place in this order.
class PairResolver {
 public:
  PairResolver(const ComparedStrokes& strokes, const std::vector<StrokePair>& pairs, const OverlapTolerance& tolerance);

  /// Decides all members, and returns what is left of them.
  std::vector<CutStroke> run();

 private:
  /// A piece that stays of an earlier partner.
  struct Hit {
    std::uint32_t member, piece;
  };

  const Stroke& stroke_of(std::uint32_t member) const { return strokes_[left_[member].number]; }
  void find_members(const ComparedStrokes& strokes, const std::vector<StrokePair>& pairs);
  void sort_into_groups(DisjointSets& groups);
  std::pair<std::uint32_t, std::uint32_t> pieces_beside(const Stroke& stroke, std::uint32_t member) const;
  void decide(std::uint32_t member);
  void cut_beaten(const std::vector<Hit>& beaten, const std::vector<Stroke>& rests);

  const std::vector<Stroke>& strokes_;
  OverlapTolerance tolerance_;
  std::vector<CutStroke> left_;               ///< by member
  std::vector<std::uint32_t> earlier_begin_;  ///< by member: its first partner in earlier_
  std::vector<std::uint32_t> earlier_;        ///< partners that are decided before the member
  std::vector<std::uint32_t> by_group_;       ///< members by group, ascending in each group
  std::vector<std::uint32_t> group_begin_;    ///< by group: its first member in by_group_
};

void PairResolver::find_members(const ComparedStrokes& strokes, const std::vector<StrokePair>& pairs) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(2 * pairs.size());
  for (const StrokePair& pair : pairs) numbers.insert(numbers.end(), {pair.first, pair.second});
  parallel_sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  parallel_sort(numbers.begin(), numbers.end(),
                [&](std::uint32_t a, std::uint32_t b) { return strokes.comes_before(a, b); });
  left_.reserve(numbers.size());
  for (const std::uint32_t number : numbers) left_.push_back({number});
}

PairResolver::PairResolver(const ComparedStrokes& strokes, const std::vector<StrokePair>& pairs,
                           const OverlapTolerance& tolerance)
    : strokes_(strokes.strokes), tolerance_(tolerance) {
  find_members(strokes, pairs);
  std::vector<std::uint32_t> member_of(strokes_.size());
  for (std::uint32_t m = 0; m < left_.size(); ++m) member_of[left_[m].number] = m;
  DisjointSets groups(left_.size());
  earlier_begin_.assign(left_.size() + 1, 0);
  for (const StrokePair& pair : pairs) {
    groups.join(member_of[pair.first], member_of[pair.second]);
    ++earlier_begin_[std::max(member_of[pair.first], member_of[pair.second]) + 1];
  }
  for (std::size_t m = 0; m < left_.size(); ++m) earlier_begin_[m + 1] += earlier_begin_[m];
  earlier_.resize(pairs.size());
  std::vector<std::uint32_t> next(earlier_begin_.begin(), earlier_begin_.end() - 1);
  for (const StrokePair& pair : pairs) {
    const std::uint32_t a = member_of[pair.first], b = member_of[pair.second];
    earlier_[next[std::max(a, b)]++] = std::min(a, b);
  }
  sort_into_groups(groups);
}

void PairResolver::sort_into_groups(DisjointSets& groups) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted;  // group, member
  for (std::uint32_t m = 0; m < left_.size(); ++m) sorted.emplace_back(groups.find(m), m);
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i].first != sorted[i - 1].first) group_begin_.push_back(i);
    by_group_.push_back(sorted[i].second);
  }
  group_begin_.push_back(static_cast<std::uint32_t>(sorted.size()));
}

std::vector<CutStroke> PairResolver::run() {
  parallel_for(group_begin_.size() - 1, [&](std::size_t g) {
    for (std::uint32_t i = group_begin_[g]; i < group_begin_[g + 1]; ++i) decide(by_group_[i]);
  });
  return std::move(left_);
}

/// The range of the pieces of a member beside a stroke. Pieces follow each other along their stroke.
std::pair<std::uint32_t, std::uint32_t> PairResolver::pieces_beside(const Stroke& stroke, std::uint32_t member) const {
  const std::vector<Stroke>& pieces = left_[member].rests;
  const Stroke& whole = stroke_of(member);
  const double dx = double(whole.to.x) - whole.from.x, dy = double(whole.to.y) - whole.from.y;
  const auto along = [&](LatticePoint p) { return dx * (double(p.x) - whole.from.x) + dy * (double(p.y) - whole.from.y); };
  const double slack = 2 * tolerance_.steps * page_length(whole);
  const double low = std::min(along(stroke.from), along(stroke.to)) - slack;
  const double high = std::max(along(stroke.from), along(stroke.to)) + slack;
  const auto first =
      std::partition_point(pieces.begin(), pieces.end(), [&](const Stroke& piece) { return along(piece.to) < low; });
  const auto last =
      std::partition_point(first, pieces.end(), [&](const Stroke& piece) { return along(piece.from) <= high; });
  return {static_cast<std::uint32_t>(first - pieces.begin()), static_cast<std::uint32_t>(last - pieces.begin())};
}

void PairResolver::decide(std::uint32_t member) {
  const Stroke& stroke = stroke_of(member);
  std::vector<CoveredPart> covered;
  std::vector<Hit> beaten;
  for (std::uint32_t e = earlier_begin_[member]; e < earlier_begin_[member + 1]; ++e) {
    const std::vector<Stroke>& pieces = left_[earlier_[e]].rests;
    const auto [first, last] = pieces_beside(stroke, earlier_[e]);
    for (std::uint32_t k = first; k < last; ++k) {
      const auto common = overlap(stroke.from, stroke.to, pieces[k].from, pieces[k].to, tolerance_.steps);
      if (!common) continue;
      if (precedes(stroke, pieces[k], *common, tolerance_.mm)) {
        beaten.push_back({earlier_[e], k});
      } else {
        covered.push_back(covered_by(pieces[k], common->a_from, common->b_from, common->a_to, common->b_to));
      }
    }
  }
  append_rests(stroke, covered, tolerance_.steps, left_[member].rests);
  cut_beaten(beaten, left_[member].rests);
}

/// Cuts the pieces that a stroke precedes, by what stays of it.
void PairResolver::cut_beaten(const std::vector<Hit>& beaten, const std::vector<Stroke>& rests) {
  // From the last piece of a member to the first, so that the others keep their places.
  for (auto hit = beaten.rbegin(); hit != beaten.rend(); ++hit) {
    std::vector<Stroke>& pieces = left_[hit->member].rests;
    const Stroke piece = pieces[hit->piece];
    std::vector<CoveredPart> covered;
    for (const Stroke& rest : rests) {
      const auto common = overlap(rest.from, rest.to, piece.from, piece.to, tolerance_.steps);
      if (common) covered.push_back(covered_by(rest, common->b_from, common->a_from, common->b_to, common->a_to));
    }
    if (covered.empty()) continue;
    std::vector<Stroke> left;
    append_rests(piece, covered, tolerance_.steps, left);
    const auto place = pieces.erase(pieces.begin() + hit->piece);
    pieces.insert(place, left.begin(), left.end());
  }
}

}  // namespace

void resolve_pairs(ComparedStrokes& strokes, const std::vector<StrokePair>& pairs, const OverlapTolerance& tolerance) {
  strokes.replace(PairResolver(strokes, pairs, tolerance).run());
}

}  // namespace ligne
