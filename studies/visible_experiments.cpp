// Experiment on the visible pieces of coplanar segments and arcs, [Boulle1980] 3.2.1.2.

#include <algorithm>
#include <cmath>

#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/operations/visible_sweep.hpp"
#include "studies/scenes/generators.hpp"

namespace ligne::studies {
namespace {

enum class Curves : std::uint8_t { opaque, half_glass, arcs };
constexpr const char* kCurveNames[] = {"opaque segments", "segments, half of them transparent",
                                       "segments and arcs, half of them transparent"};

/// n curves over a square of 4,000 steps, about as long as their mean distance times five.
std::vector<PlaneCurve> curves_in_plane(int n, Curves kind) {
  Chance chance(23);
  constexpr int kSide = 4000;
  const int length = std::max(4, static_cast<int>(5 * kSide / std::sqrt(n)));
  std::vector<PlaneCurve> curves;
  for (int i = 0; i < n; ++i) {
    const bool is_transparent = kind != Curves::opaque && i % 2 == 1;
    const LatticePoint at{chance.whole(0, kSide), chance.whole(0, kSide)};
    const int across = chance.whole(1, length), along = chance.whole(-length, length);
    if (kind == Curves::arcs && i % 4 < 2) {
      const auto half = chance.whole(0, 1) ? PlaneCurve::Kind::near_arc : PlaneCurve::Kind::far_arc;
      curves.push_back(PlaneCurve::arc(half, at, (across + 1) / 2, {at.x - across, at.x + across}, is_transparent));
    } else {
      // Within the limit of exact decisions.
      const LatticePoint end{std::min(at.x + across, kCurveLimit), std::clamp(at.y + along, 0, kCurveLimit)};
      curves.push_back(PlaneCurve::segment(at, end, is_transparent));
    }
  }
  return curves;
}

/// A known answer: the pieces of a named plane, in words.
struct Known {
  const char *plane, *thesis;
  std::vector<PlaneCurve> curves;
};

std::vector<Known> known_planes() {
  const auto opaque = [](LatticePoint a, LatticePoint b) { return PlaneCurve::segment(a, b); };
  const auto glass = [](LatticePoint a, LatticePoint b) { return PlaneCurve::segment(a, b, true); };
  std::vector<PlaneCurve> ball = circle({10, 10}, 5, true);
  ball.push_back(opaque({0, 10}, {20, 10}));
  ball.push_back(opaque({0, 7}, {20, 7}));
  return {{"two segments that cross", "an order at each step", {opaque({0, 0}, {6, 6}), opaque({0, 6}, {6, 0})}},
          {"a wall behind two panes",
           "transparency: the order of all",
           {glass({0, 1}, {8, 1}), glass({4, 3}, {12, 3}), opaque({0, 9}, {12, 9})}},
          {"two walls in a ball of glass", "extends to arcs of one concavity", std::move(ball)}};
}

Table known_answers() {
  Table table{"Small planes; the viewer looks along +z",
              {{"plane", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"curve", ColumnKind::count},
               {"from", ColumnKind::measure},
               {"to", ColumnKind::measure},
               {"transparent curves in front", ColumnKind::count}}};
  for (const Known& known : known_planes()) {
    VisibleWork work;
    for (const VisiblePiece& piece : visible_by_sweep(known.curves, work)) {
      table.rows.push_back({known.plane, known.thesis, std::uint64_t{piece.curve}, piece.from.value(), piece.to.value(),
                            std::uint64_t{piece.level}});
    }
  }
  return table;
}

}  // namespace

Result study_visible_segments(const StudyRequest& request) {
  Table table{"Visible pieces by a sweep",
              {{"curves", ColumnKind::label},
               {"n", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"stops", ColumnKind::count},
               {"p pieces", ColumnKind::count},
               {"seen through others", ColumnKind::count},
               {"pairs tested", ColumnKind::count},
               {"comparisons", ColumnKind::count},
               {"comparisons over (stops + p) log2 n", ColumnKind::measure},
               {"all pairs give the same", ColumnKind::words},
               {"ms", ColumnKind::time}}};
  bool is_same = true;
  for (const Curves kind : {Curves::opaque, Curves::half_glass, Curves::arcs}) {
    for (int n = 100; n <= request.pick(100, 6400); n *= 4) {
      const std::vector<PlaneCurve> curves = curves_in_plane(n, kind);
      VisibleWork work;
      std::vector<VisiblePiece> pieces;
      const double seconds = least_seconds(1, [&] { pieces = visible_by_sweep(curves, work); });
      const bool is_checked = n <= 400;  // all pairs take the square and more
      const bool agrees = !is_checked || pieces == visible_by_pairs(curves);
      is_same = is_same && agrees;
      const auto through = std::ranges::count_if(pieces, [](const VisiblePiece& piece) { return piece.level > 0; });
      const double bound = double(work.stops + pieces.size()) * std::log2(n);
      table.rows.push_back({kCurveNames[static_cast<int>(kind)], std::to_string(n), "O(n log n + k log n)", work.stops,
                            std::uint64_t{pieces.size()}, static_cast<std::uint64_t>(through), work.pairs, work.comparisons,
                            double(work.comparisons) / bound,
                            std::string(!is_checked ? "not asked"
                                        : agrees    ? "yes"
                                                    : "no"),
                            1e3 * seconds});
    }
  }
  Result result{.tables = {known_answers(), std::move(table)}, .finding = is_same ? Finding::holds : Finding::no_longer};
  result.sentence =
      "The order of all curves that the sweep has at each stop gives the visible pieces, and behind how many transparent curves "
      "each lies; arcs take the same sweep, with crossings at roots of squares in place of quotients.";
  return result;
}

}  // namespace ligne::studies
