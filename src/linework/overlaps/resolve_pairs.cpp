/// Strokes are decided one after the other, in the order of precedence. A stroke is compared with the pieces that stay of
/// its partners before it:
/// - It loses the common intervals with pieces that precede it.
/// - Pieces that it precedes nevertheless lose their common intervals with its rests. This happens because precedence
///   depends on the depth in the middle of the common interval, while the order is by the depth in the middle of whole
///   strokes.

#include "linework/overlaps/compared_strokes.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace ligne {
namespace {

/// The part of a stroke that another one covers. The fractions are of both strokes at the ends of their common interval.
CoveredPart covered_by(const Stroke& other, double from, double other_from, double to, double other_to) {
  const auto end = [&](double fraction) { return fraction < 0.5 ? other.from : other.to; };
  CoveredPart part{{from, end(other_from)}, {to, end(other_to)}};
  if (from > to) std::swap(part.from, part.to);
  return part;
}

class PairResolver {
 public:
  PairResolver(const std::vector<Stroke>& strokes, const OverlapTolerance& tolerance)
      : strokes_(strokes), tolerance_(tolerance), left_(strokes.size()) {}

  /// Decides a stroke. `pairs` are those in which it is the later one; the others in them have been decided.
  void decide(std::uint32_t number, std::span<const StrokePair> pairs);
  std::vector<Stroke>& left_of(std::uint32_t number) { return left_[number]; }

 private:
  /// A piece that stays of an earlier stroke.
  struct Hit {
    std::uint32_t stroke, piece;
  };

  std::pair<std::uint32_t, std::uint32_t> pieces_beside(const Stroke& stroke, std::uint32_t other) const;
  void cut_beaten(const std::vector<Hit>& beaten, const std::vector<Stroke>& rests);

  const std::vector<Stroke>& strokes_;
  OverlapTolerance tolerance_;
  std::vector<std::vector<Stroke>> left_;  ///< what stays of each stroke that was decided
};

/// The range of the pieces of another stroke beside a stroke. Pieces follow each other along their stroke.
std::pair<std::uint32_t, std::uint32_t> PairResolver::pieces_beside(const Stroke& stroke, std::uint32_t other) const {
  const std::vector<Stroke>& pieces = left_[other];
  const Stroke& whole = strokes_[other];
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

void PairResolver::decide(std::uint32_t number, std::span<const StrokePair> pairs) {
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

/// Cuts the pieces that a stroke precedes, by what stays of it.
void PairResolver::cut_beaten(const std::vector<Hit>& beaten, const std::vector<Stroke>& rests) {
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

}  // namespace

std::vector<Stroke> rests_of(const Stroke& stroke, std::vector<CoveredPart>& covered, double tolerance_steps) {
  std::sort(covered.begin(), covered.end(), [](const CoveredPart& l, const CoveredPart& r) {
    return std::tie(l.from.fraction, l.to.fraction) < std::tie(r.from.fraction, r.to.fraction);
  });
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

void ComparedStrokes::replace(std::span<const CutStroke> cut) {
  ComparedStrokes changed;
  changed.strokes.reserve(strokes.size() + cut.size());
  changed.is_new.reserve(strokes.size() + cut.size());
  auto next = cut.begin();
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    const Stroke& whole = strokes[i];
    if (next == cut.end() || next->number != i) {
      changed.strokes.push_back(whole);
      changed.is_new.push_back(0);
      continue;
    }
    const std::vector<Stroke>& rests = (next++)->rests;
    const bool is_whole = rests.size() == 1 && rests[0].from == whole.from && rests[0].to == whole.to;
    changed.strokes.insert(changed.strokes.end(), rests.begin(), rests.end());
    changed.is_new.insert(changed.is_new.end(), rests.size(), !is_whole);
  }
  *this = std::move(changed);
}

std::vector<CutStroke> resolve_pairs(const std::vector<Stroke>& strokes, std::span<const StrokePair> pairs,
                                     const OverlapTolerance& tolerance) {
  std::vector<std::uint8_t> is_in_pair(strokes.size(), 0);
  for (const StrokePair& pair : pairs) is_in_pair[pair.later] = is_in_pair[pair.earlier] = 1;
  PairResolver resolver(strokes, tolerance);
  std::size_t first = 0, last = 0;
  for (std::uint32_t i = 0; i < strokes.size(); ++i, first = last) {
    while (last < pairs.size() && pairs[last].later == i) ++last;
    if (is_in_pair[i]) resolver.decide(i, pairs.subspan(first, last - first));
  }
  std::vector<CutStroke> cut;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (is_in_pair[i]) cut.push_back({i, std::move(resolver.left_of(i))});
  }
  return cut;
}

}  // namespace ligne
