// Experiments on segments: pairs, many at once, and clipping, [Boulle1980] 3.2.1 and 3.2.3.1.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "geometry/exact_segment.hpp"
#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/operations/segment_clipping.hpp"
#include "studies/operations/segment_sweep.hpp"
#include "studies/operations/segment_tests.hpp"
#include "studies/scenes/generators.hpp"

namespace ligne::studies {
namespace {

using Real = Counted<double>;

struct Pair {
  LatticePoint a, b, c, d;
};

/// Pairs of segments on the lattice: in general position, with ends on each other, and with ends within one step of the
/// other segment.
std::vector<Pair> pairs_of_segments(int n) {
  Chance chance(3);
  constexpr int kLimit = kLatticeLimit;
  const auto point = [&] { return LatticePoint{chance.whole(-kLimit, kLimit), chance.whole(-kLimit, kLimit)}; };
  std::vector<Pair> pairs;
  for (int i = 0; i < n; ++i) {
    Pair p{point(), point(), point(), point()};
    const int kind = i % 4;
    if (kind == 1) p.c = chance.whole(0, 1) ? p.a : p.b;
    if (kind >= 2) {
      // An end near a point of AB, or near its end B.
      const double t = kind == 2 ? chance.uniform(0, 1) : 1;
      p.c = {static_cast<std::int32_t>(std::lround(p.a.x + t * (double(p.b.x) - p.a.x))),
             static_cast<std::int32_t>(std::lround(p.a.y + t * (double(p.b.y) - p.a.y)))};
      if (kind == 3)
        p.c = {std::clamp(p.c.x + chance.whole(-1, 1), -kLimit, kLimit),
               std::clamp(p.c.y + chance.whole(-1, 1), -kLimit, kLimit)};
    }
    if (!(p.a == p.b) && !(p.c == p.d)) pairs.push_back(p);
  }
  return pairs;
}

int sign(double v) { return (v > 0) - (v < 0); }

/// The program's own test: signs of exact determinants.
bool cross_truly(const Pair& p) {
  return sign(orientation(p.a, p.b, p.c)) * sign(orientation(p.a, p.b, p.d)) < 0 &&
         sign(orientation(p.c, p.d, p.a)) * sign(orientation(p.c, p.d, p.b)) < 0;
}

/// True if the closed segments meet and are not parallel.
bool meet_truly(const Pair& p) {
  if (cross(LatticeSegment{p.a, p.b}, LatticeSegment{p.c, p.d}) == 0) return false;
  return sign(orientation(p.a, p.b, p.c)) * sign(orientation(p.a, p.b, p.d)) <= 0 &&
         sign(orientation(p.c, p.d, p.a)) * sign(orientation(p.c, p.d, p.b)) <= 0;
}

template <class N>
using SegmentTest = bool (*)(const PlanePoint<N>&, const PlanePoint<N>&, const PlanePoint<N>&, const PlanePoint<N>&);

template <class N, class Make>
bool ask(SegmentTest<N> test, const Pair& p, const Make& make) {
  const auto point = [&](LatticePoint q) { return PlanePoint<N>{make(q.x), make(q.y)}; };
  return test(point(p.a), point(p.b), point(p.c), point(p.d));
}

struct Method {
  const char *name, *thesis;
  SegmentTest<Real> counted;
  SegmentTest<double> plain;
  SegmentTest<Int128> whole;
  bool closed;  ///< true if a common end counts as crossing
};
constexpr Method kSegmentMethods[] = {
    {"analytic", "14 / 14 / 3 / 0", cross_analytic<Real>, cross_analytic<double>, cross_analytic<Int128>, false},
    {"vector", "12 / 10 / 3 / 0", cross_vector<Real>, cross_vector<double>, cross_vector<Int128>, false},
    {"parametric", "6 / 6 / 5 / 7", cross_parametric<Real>, cross_parametric<double>, cross_parametric<Int128>, false},
    {"min-max", "9 / 12 / 17 / 1", meet_min_max<Real>, meet_min_max<double>, meet_min_max<Int128>, true},
};

std::vector<LatticeSegment> random_segments(int n, int length, std::uint64_t seed) {
  Chance chance(seed);
  std::vector<LatticeSegment> segments;
  while (segments.size() < static_cast<std::size_t>(n)) {
    const LatticePoint a{chance.whole(-8000, 8000), chance.whole(-8000, 8000)};
    const LatticePoint b{a.x + chance.whole(-length, length), a.y + chance.whole(-length, length)};
    if (!(a == b)) segments.push_back({a, b});
  }
  return segments;
}

}  // namespace

Result study_segment_tests(const StudyRequest& request) {
  const std::vector<Pair> pairs = pairs_of_segments(request.pick(2000, 200000));
  Table table{"Operations of one test at the most: + (with -), x (with /), ?, :=; and answers on " +
                  std::to_string(pairs.size()) + " pairs, three quarters of which touch or nearly touch",
              {{"method", ColumnKind::label},
               {"thesis: + / x / ? / :=", ColumnKind::source},
               {"+", ColumnKind::count},
               {"x", ColumnKind::count},
               {"of them /", ColumnKind::count},
               {"?", ColumnKind::count},
               {":=", ColumnKind::count},
               {"wrong in doubles", ColumnKind::count},
               {"wrong in whole numbers", ColumnKind::count},
               {"ns", ColumnKind::time}}};
  bool exact = true;
  for (const Method& m : kSegmentMethods) {
    Operations most;
    std::uint64_t wrong = 0, wrong_whole = 0;
    for (const Pair& p : pairs) {
      Operations tally;
      ask<Real>(m.counted, p, [&](double v) { return Real(v, &tally); });
      if (tally.total() > most.total()) most = tally;
      const bool truth = m.closed ? meet_truly(p) : cross_truly(p);
      wrong += ask<double>(m.plain, p, [](double v) { return v; }) != truth;
      wrong_whole += ask<Int128>(m.whole, p, [](double v) { return static_cast<Int128>(v); }) != truth;
    }
    exact = exact && wrong_whole == 0;
    const double seconds = seconds_each([&] {
      int crossing = 0;
      for (const Pair& p : pairs) crossing += ask<double>(m.plain, p, [](double v) { return v; });
      return crossing;
    });
    table.rows.push_back({m.name, m.thesis, most.sums(), most.products + most.quotients, most.quotients, most.tests,
                          most.assignments, wrong, wrong_whole, 1e9 * seconds / double(pairs.size())});
  }
  std::uint64_t wrong = 0;
  const double seconds = seconds_each([&] {
    int crossing = 0;
    for (const Pair& p : pairs) crossing += cross_truly(p);
    return crossing;
  });
  // Four determinants of five sums and two products each, and two products of signs.
  table.rows.push_back({"four exact determinants, the program's", std::string(kNoFigure), std::uint64_t{20},
                        std::uint64_t{10}, std::uint64_t{0}, std::uint64_t{3}, std::uint64_t{0}, wrong, wrong,
                        1e9 * seconds / double(pairs.size())});
  Result result;
  result.tables.push_back(std::move(table));
  result.finding = exact ? Finding::in_part : Finding::no_longer;
  result.sentence =
      "The counts of the analytic, the vector and the min-max test are those of the thesis to the last one; the parametric test "
      "takes nine sums, not six, for those of its three determinants were left out there. The test with the fewest operations is not the fastest any more: quotients and branches cost more than sums and products; and only "
      "min-max errs in doubles.";
  return result;
}

Result study_many_segments(const StudyRequest& request) {
  struct Family {
    const char* name;
    int length;
  };
  constexpr Family kFamilies[] = {{"short", 300}, {"middling", 2000}, {"long", 8000}};
  Table table{"n segments: points in which they meet",
              {{"segments", ColumnKind::label},
               {"n", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"k points", ColumnKind::count},
               {"pairs tested by the sweep", ColumnKind::count},
               {"comparisons of the sweep", ColumnKind::count},
               {"comparisons over (n + k) log2 n", ColumnKind::measure},
               {"n (n - 1) / 2 pairs", ColumnKind::count},
               {"the same points", ColumnKind::words},
               {"sweep over all pairs, time", ColumnKind::time}}};
  Chart chart{"Time of the sweep over that of all pairs", "segments", "ratio"};
  chart.logarithmic = true;
  bool same = true, short_wins = false, long_loses = false;
  for (const Family& f : kFamilies) {
    chart.curves.push_back({f.name, {}});
    for (int n = 50; n <= request.pick(200, f.length > 4000 ? 800 : 3200); n *= 2) {
      const std::vector<LatticeSegment> segments = random_segments(n, f.length, 17);
      SweepWork sweep, pairs;
      std::vector<MeetingPoint> by_sweep, by_pairs;
      const double t_sweep = least_seconds(1, [&] { by_sweep = meetings_by_sweep(segments, sweep); });
      const double t_pairs = least_seconds(1, [&] { by_pairs = meetings_by_pairs(segments, pairs); });
      const bool agree = by_sweep == by_pairs;
      same = same && agree;
      const double k = double(by_pairs.size()), ratio = times_as_long(t_sweep, t_pairs);
      if (n >= 1600 && ratio < 1) short_wins = true;
      if (f.length > 4000 && ratio > 1) long_loses = true;
      table.rows.push_back({f.name, std::to_string(n), "(n + k) log n against n^2", std::uint64_t{by_pairs.size()},
                            sweep.pairs, sweep.comparisons, double(sweep.comparisons) / ((n + k) * std::log2(n)),
                            pairs.pairs, agree ? "yes" : "no", ratio});
      chart.curves.back().points.emplace_back(n, ratio);
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.charts.push_back(std::move(chart));
  result.finding = !same                                           ? Finding::no_longer
                   : (short_wins && long_loses) || !request.full() ? Finding::holds
                                                                   : Finding::in_part;
  result.sentence =
      "The sweep finds the same points as all pairs, exactly, and its comparisons stay in proportion to (n + k) log n; it is the "
      "faster one only for many segments that seldom meet, since a pair costs a few nanoseconds and a stop of the sweep hundreds, "
      "and where k is near n squared it is far behind, as the thesis says.";
  return result;
}

namespace {

constexpr int kScreenPoints = 1 << 10;
constexpr ClipRectangle kScreenPart{256, 767, 256, 767};

using ScreenSegment = std::pair<Point2, Point2>;

/// Segments grouped by the number of their ends inside, with the bounds of the thesis.
struct SegmentKind {
  const char *name, *codes, *middles;
  ClipCounts most_by_halving, most_by_codes;
  std::uint64_t segments = 0, different = 0;
};

void enlarge(ClipCounts& most, const ClipCounts& c) {
  most.codes = std::max(most.codes, c.codes);
  most.crossings = std::max(most.crossings, c.crossings);
  most.middles = std::max(most.middles, c.middles);
}

std::vector<ScreenSegment> screen_segments(int n) {
  Chance chance(23);
  const auto whole = [&] {
    return Point2{double(chance.whole(0, kScreenPoints - 1)), double(chance.whole(0, kScreenPoints - 1))};
  };
  std::vector<ScreenSegment> segments;
  for (int i = 0; i < n; ++i) {
    const Point2 p = whole();
    segments.emplace_back(p, whole());
  }
  return segments;
}

/// Largest distance between the ends that the two methods find, in steps.
double clip_both_ways(const std::vector<ScreenSegment>& segments, std::span<SegmentKind, 3> kinds) {
  const ClipRectangle& r = kScreenPart;
  double farthest = 0;
  for (const auto& [p, q] : segments) {
    SegmentKind& kind = kinds[(r.code(p) != 0) + (r.code(q) != 0)];
    ClipCounts halving, codes;
    const ClippedSegment a = clip_by_halving(p, q, r, halving), b = clip_by_codes(p, q, r, codes);
    ++kind.segments;
    enlarge(kind.most_by_halving, halving);
    enlarge(kind.most_by_codes, codes);
    kind.different += a.has_value() != b.has_value();
    if (a && b) {
      for (const Point2 d : {a->first - b->first, a->second - b->second})
        farthest = std::max({farthest, std::abs(d.x), std::abs(d.y)});
    }
  }
  return farthest;
}

double clip_seconds(const std::vector<ScreenSegment>& segments, bool halving) {
  return seconds_each([&] {
           ClipCounts counts;
           double sum = 0;
           for (const auto& [p, q] : segments) {
             const ClippedSegment s =
                 halving ? clip_by_halving(p, q, kScreenPart, counts) : clip_by_codes(p, q, kScreenPart, counts);
             if (s) sum += s->first.x;
           }
           return sum;
         }) /
         double(segments.size());
}

/// Segments clipped by convex contours on the screen, with outcodes of n bits.
Table clipped_by_contours(const std::vector<ScreenSegment>& segments) {
  Table table{"A segment clipped by codes of n bits, by a convex contour of n sides",
              {{"n", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"points coded", ColumnKind::measure},
               {"signs", ColumnKind::measure},
               {"crossings", ColumnKind::measure},
               {"most crossings", ColumnKind::count},
               {"ns", ColumnKind::time}}};
  for (const unsigned n : {4u, 8u, 16u, 32u, 64u}) {
    constexpr double kMiddle = kScreenPoints / 2.0, kRadius = kScreenPoints / 3.0;
    ClipContour contour;
    for (unsigned i = 0; i < n; ++i) {
      const double angle = 0.1 + 2 * std::numbers::pi * i / n;
      contour.corners.emplace_back(kMiddle + kRadius * std::cos(angle), kMiddle + kRadius * std::sin(angle));
    }
    ClipCounts sum;
    std::uint64_t most = 0;
    for (const auto& [p, q] : segments) {
      ClipCounts counts;
      clip_by_codes(p, q, contour, counts);
      sum.codes += counts.codes;
      sum.crossings += counts.crossings;
      most = std::max(most, counts.crossings);
    }
    const double m = double(segments.size());
    const double seconds = seconds_each([&] {
      ClipCounts unused;
      std::size_t parts = 0;
      for (const auto& [p, q] : segments) parts += clip_by_codes(p, q, contour, unused).has_value();
      return parts;
    });
    table.rows.push_back({std::to_string(n), "a code of length n; at most n crossings", double(sum.codes) / m,
                          n * double(sum.codes) / m, double(sum.crossings) / m, most, 1e9 * seconds / m});
  }
  return table;
}

}  // namespace

Result study_segment_clipping(const StudyRequest& request) {
  SegmentKind kinds[] = {{"both ends inside", "2", "0", {}, {}},
                         {"one end inside", "< k + 1 = 11", "< k = 10", {}, {}},
                         {"no end inside", "< 2 k + 2 = 22", "< 2 k = 20", {}, {}}};
  const int n = request.pick(5000, 200000);
  const std::vector<ScreenSegment> segments = screen_segments(n);
  const double farthest = clip_both_ways(segments, kinds);
  Table table{"Halving on a screen of 2^10 points, the most over " + std::to_string(n) + " segments",
              {{"segment", ColumnKind::label},
               {"what", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"most", ColumnKind::count},
               {"segments", ColumnKind::count},
               {"decided otherwise by codes", ColumnKind::count}}};
  for (const SegmentKind& k : kinds) {
    table.rows.push_back(
        {k.name, "points against the rectangle", k.codes, k.most_by_halving.codes, k.segments, k.different});
    table.rows.push_back({k.name, "middles", k.middles, k.most_by_halving.middles, k.segments, k.different});
  }
  table.rows.push_back({"any", "crossings computed by codes", "at most 4", kinds[2].most_by_codes.crossings,
                        std::uint64_t{segments.size()}, std::uint64_t{0}});
  Table times{"Time of one segment",
              {{"method", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"ns", ColumnKind::time},
               {"farthest apart, steps", ColumnKind::measure}}};
  const double by_halving = 1e9 * clip_seconds(segments, true), by_codes = 1e9 * clip_seconds(segments, false);
  times.rows.push_back({"halving", "no crossing to compute: for hardware", by_halving, farthest});
  times.rows.push_back({"codes", "a costly crossing", by_codes, 0.0});
  Result result{.tables = {std::move(table), std::move(times), clipped_by_contours(segments)},
                .finding = by_codes < by_halving ? Finding::in_part : Finding::holds};
  result.sentence =
      "The bounds of the thesis are reached, where it has them strict: a segment with one end inside takes up to k middles. A "
      "division costs less than ten halvings today, so codes are faster, and right but for a rounding, where rounded middles leave "
      "a segment that runs along a side at the wrong place, or do not find it.";
  return result;
}

}  // namespace ligne::studies
